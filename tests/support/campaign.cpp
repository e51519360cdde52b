#include "tests/support/campaign.hpp"

#include <nlohmann/json.hpp>

#include "runner/daemon/process_identity.hpp"
#include "runner/doctor/database_checks.hpp"
#include "runner/store/database.hpp"

namespace capstan {
namespace {

Database reader_of(const std::filesystem::path& data) {
  return Database(data / "capstan.sqlite", Database::Access::read);
}

std::string without_cost(const std::string& document) {
  nlohmann::json result = nlohmann::json::parse(document.empty() ? "{}" : document);
  for (const char* key : {"seconds", "peak_memory_mb"})
    if (result.contains("cost")) result["cost"].erase(key);
  const nlohmann::json::json_pointer companion("/error/companion");
  if (result.contains(companion) && result[companion].is_object()) result[companion].erase("seconds");
  return result.dump();
}

bool has_rows(Database& database, const char* sql) { return database.query(sql).step(); }

}  // namespace

std::map<std::string, Answer> answers_in(const std::filesystem::path& data) {
  Database database = reader_of(data);
  std::map<std::string, Answer> answers;
  Statement row = database.query(
      "SELECT id, state, coalesce(r.document, ''),"
      " (SELECT count(*) FROM attempts a WHERE a.case_id = id AND ending IN ('done', 'diverged')),"
      " (SELECT coalesce(group_concat(record || ' ' || kt || ' ' || D_xy || ' ' || theta || ' ' || psi), '')"
      "  FROM histories h WHERE h.case_id = id) FROM cases LEFT JOIN results r ON r.case_id = id");
  while (row.step())
    answers[row.text(0)] = {row.text(1), without_cost(row.text(2)), row.text(4),
                            static_cast<int>(row.integer(3))};
  return answers;
}

std::string broken_promise(const std::filesystem::path& data) {
  Database database = reader_of(data);
  for (const std::string& damage : damage_of(database)) return damage;
  for (const std::string& study : miscounted_studies(database)) return "the sums of " + study;
  if (has_rows(
          database,
          "SELECT 1 FROM attempts WHERE ending IN ('done', 'diverged') GROUP BY case_id HAVING count(*) > 1"))
    return "a case has two answers";
  if (has_rows(database,
               "SELECT 1 FROM cases c WHERE (state = 'running') <>"
               " (SELECT count(*) FROM attempts a WHERE a.case_id = c.id AND ended_at IS NULL)"))
    return "a running case without an open attempt, or an open attempt of another";
  if (has_rows(database,
               "SELECT 1 FROM cases LEFT JOIN results ON case_id = id"
               " WHERE (state IN ('done', 'diverged')) <> (case_id IS NOT NULL)"))
    return "an answer without a result, or a result without an answer";
  return "";
}

std::vector<pid_t> workers_of(const std::filesystem::path& data) {
  Database database = reader_of(data);
  std::vector<pid_t> workers;
  Statement row = database.query(
      "SELECT a.handle FROM attempts a JOIN cases c ON c.id = a.case_id AND c.attempt = a.attempt"
      " WHERE c.state = 'running'");
  while (row.step()) {
    const auto process = process_from_text(row.text(0));
    if (process && is_alive(*process)) workers.push_back(process->pid);
  }
  return workers;
}

}  // namespace capstan
