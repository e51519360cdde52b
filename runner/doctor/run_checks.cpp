#include "runner/doctor/run_checks.hpp"

#include "runner/recording/history.hpp"
#include "runner/store/orphans.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

std::optional<ordered_json> readable_result(const RunDirectory& directory) try {
  return directory.result();
} catch (const std::filesystem::filesystem_error& error) {
  if (is_shortage(error)) throw;
  return std::nullopt;
}

/// The database is what answers: a result file that is lost or damaged is written again.
void compare_results(const std::filesystem::path& runs, Database& database, const RunFault& tell) {
  Statement row = database.query("SELECT case_id, document FROM results");
  while (row.step()) {
    const RunDirectory directory(runs / row.text(0));
    const std::string document = row.text(1);
    const auto there = readable_result(directory);
    if (there && *there == ordered_json::parse(document)) continue;
    tell(directory.result_file().string() + (there ? " is not what was recorded" : " is missing or damaged"),
         [&] {
           std::filesystem::create_directories(directory.path());
           write_durably(directory.result_file(), ordered_json::parse(document).dump(2) + "\n");
         });
  }
}

/// Of one that has ended: what does not agree between its history.jsonl and its rows, and what would mend it.
void compare_history(const RunDirectory& directory, const std::string& case_id, Database& database,
                     const RunFault& tell) {
  const HistoryFile file = read_history(directory.history_file());
  const History stored = stored_history(database, case_id);
  const auto store = [&, case_id, file] {
    Transaction transaction(database);
    store_history_file(database, case_id, file);
    transaction.commit();
  };
  const std::string rows = std::to_string(stored.size());
  if (file.damage.empty() && stored.size() != file.records.size())
    tell("the database holds " + rows + " of the " + std::to_string(file.records.size()) + " records in " +
             directory.history_file().string(),
         store);
  else if (!file.damage.empty() && (!stored.empty() || file.damage != "is missing"))
    tell(directory.history_file().string() + " " + file.damage + "; the database holds " + rows + " records",
         [&, store] {
           store();
           std::filesystem::create_directories(directory.path());
           write_durably(directory.history_file(), history_lines(stored_history(database, case_id)));
         });
}

void compare_histories(const std::filesystem::path& runs, Database& database, const RunFault& tell) {
  Statement row = database.query("SELECT id FROM cases WHERE state IN ('done', 'diverged')");
  while (row.step()) compare_history(RunDirectory(runs / row.text(0)), row.text(0), database, tell);
}

void find_cases_without_history(Database& database, const RunFault& tell) {
  Statement row = database.query(
      "SELECT id FROM cases WHERE state = 'done' AND NOT EXISTS (SELECT 1 FROM histories WHERE case_id = "
      "id)");
  while (row.step()) tell("case " + row.text(0) + " is done, but has no history", {});
}

void find_missing_results(Database& database, const RunFault& tell) {
  Statement row = database.query(
      "SELECT id FROM cases LEFT JOIN results ON case_id = id WHERE state = 'done' AND case_id IS NULL");
  while (row.step())
    tell("case " + row.text(0) + " is done, but has no result", [&, id = row.text(0)] {
      Transaction transaction(database);
      database.execute("UPDATE cases SET state = 'queued', message = 'its result was lost' WHERE id = ?", id);
      transaction.commit();
    });
}

void find_orphans(const std::filesystem::path& runs, Database& database, const RunFault& tell) {
  for (const RunDirectory& orphan : orphans_in(runs, database)) {
    const std::string what = orphan.path().string() + " belongs to no case";
    if (orphan.is_worthless())
      tell(what + " and holds nothing", [&] { std::filesystem::remove_all(orphan.path()); });
    else
      tell(what + ": submit its study again, or delete it", {});
  }
}

void find_partial_files(const std::filesystem::path& runs, Database& database, const RunFault& tell) {
  Statement row = database.query("SELECT id FROM cases WHERE state <> 'running'");
  while (row.step()) {
    const RunDirectory directory(runs / row.text(0));
    if (directory.has_partial_files())
      tell(directory.path().string() + " holds half-written files",
           [&] { directory.remove_partial_files(); });
  }
}

}  // namespace

void find_run_faults(const std::filesystem::path& runs, Database& database, const RunFault& tell) {
  compare_results(runs, database, tell);
  compare_histories(runs, database, tell);
  find_cases_without_history(database, tell);
  find_missing_results(database, tell);
  find_orphans(runs, database, tell);
  find_partial_files(runs, database, tell);
}

}  // namespace capstan
