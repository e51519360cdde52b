#include "runner/daemon/delete_study.hpp"

#include "runner/store/fail_point.hpp"

namespace capstan {
namespace {

/// Deletes the rows of unwanted_cases whose case a study contains, or has replaced by another case. Returns
/// their number.
int keep_wanted_cases(Database& database) {
  return database.execute(
      "DELETE FROM unwanted_cases"
      " WHERE EXISTS (SELECT 1 FROM study_cases w WHERE w.case_id = unwanted_cases.case_id)"
      " OR EXISTS (SELECT 1 FROM study_cases w WHERE w.replaces = unwanted_cases.case_id)");
}

}  // namespace

std::optional<Deletion> delete_study(Database& database, JobQueue& queue, const std::string& study_id) {
  Transaction transaction(database);
  if (!queue.cancel(study_id)) return std::nullopt;
  const int all = database.execute(
      "INSERT OR IGNORE INTO unwanted_cases SELECT case_id FROM study_cases WHERE study_id = ?1"
      " UNION SELECT replaces FROM study_cases WHERE study_id = ?1 AND replaces IS NOT NULL",
      study_id);
  for (const char* table : {"tallies", "study_cases", "schedule"})
    database.execute("DELETE FROM " + std::string(table) + " WHERE study_id = ?", study_id);
  database.execute("DELETE FROM studies WHERE id = ?", study_id);
  const int kept = keep_wanted_cases(database);
  transaction.commit();
  return Deletion{all - kept, kept};
}

std::vector<std::string> delete_unwanted_cases(Database& database, int max) {
  if (!database.query("SELECT 1 FROM unwanted_cases LIMIT 1").step()) return {};
  Transaction transaction(database);
  keep_wanted_cases(database);  // those that were submitted again meanwhile
  std::vector<std::string> ids;
  Statement row = database.query(
      "SELECT case_id FROM unwanted_cases LEFT JOIN cases ON id = case_id WHERE state IS NOT 'running'"
      " LIMIT ?",
      max);
  while (row.step()) ids.push_back(row.text(0));
  for (const std::string& id : ids) {
    for (const char* table : {"histories", "results", "attempts"})
      database.execute("DELETE FROM " + std::string(table) + " WHERE case_id = ?", id);
    database.execute("DELETE FROM cases WHERE id = ?", id);
  }
  transaction.commit();
  fail_point("deleted");
  return ids;
}

void forget_deleted(Database& database, const std::vector<std::string>& case_ids) {
  if (case_ids.empty()) return;
  Transaction transaction(database, Survives::kill);
  for (const std::string& id : case_ids) database.execute("DELETE FROM unwanted_cases WHERE case_id = ?", id);
  transaction.commit();
}

}  // namespace capstan
