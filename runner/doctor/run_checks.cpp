#include "runner/doctor/run_checks.hpp"

#include <nlohmann/json.hpp>

#include "runner/recording/history.hpp"
#include "runner/store/orphaned_runs.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// The content of result.json; nothing if it is missing, damaged or cannot be read.
std::optional<ordered_json> readable_result(const RunDirectory& directory) try {
  return directory.result();
} catch (const std::filesystem::filesystem_error& error) {
  if (is_shortage(error)) throw;
  return std::nullopt;
}

/// The server answers from the database, so a result file that differs from it is written again.
void check_results(const std::filesystem::path& runs, Database& database, const ReportFinding& report) {
  Statement row = database.query("SELECT case_id, document FROM results");
  while (row.step()) {
    const RunDirectory directory(runs / row.text(0));
    const std::string document = row.text(1);
    const auto found = readable_result(directory);
    if (found && *found == ordered_json::parse(document)) continue;
    report(
        directory.result_file().string() + (found ? " is not what was recorded" : " is missing or damaged"),
        [&] {
          std::filesystem::create_directories(directory.path());
          write_durably(directory.result_file(), ordered_json::parse(document).dump(2) + "\n");
        });
  }
}

/// Compares the history of an ended case in the database with that in its file. Records that are missing in
/// one of them are copied from the other.
void check_history(const RunDirectory& directory, const std::string& case_id, Database& database,
                   const ReportFinding& report) {
  const HistoryFile file = read_history(directory.history_file());
  const History stored = stored_history(database, case_id);
  const auto store = [&, case_id, file] {
    Transaction transaction(database);
    store_history_file(database, case_id, file);
    transaction.commit();
  };
  const std::string rows = std::to_string(stored.size());
  if (file.damage.empty() && stored.size() != file.records.size())
    report("the database holds " + rows + " of the " + std::to_string(file.records.size()) + " records in " +
               directory.history_file().string(),
           store);
  else if (!file.damage.empty() && (!stored.empty() || file.damage != "is missing"))
    report(
        directory.history_file().string() + " " + file.damage + "; the database holds " + rows + " records",
        [&, store] {
          store();
          std::filesystem::create_directories(directory.path());
          write_durably(directory.history_file(), history_lines(stored_history(database, case_id)));
        });
}

void check_histories(const std::filesystem::path& runs, Database& database, const ReportFinding& report) {
  Statement row = database.query("SELECT id FROM cases WHERE state IN ('done', 'diverged')");
  while (row.step()) check_history(RunDirectory(runs / row.text(0)), row.text(0), database, report);
}

void check_done_cases_have_histories(Database& database, const ReportFinding& report) {
  Statement row = database.query(
      "SELECT id FROM cases WHERE state = 'done' AND NOT EXISTS (SELECT 1 FROM histories WHERE case_id = "
      "id)");
  while (row.step()) report("case " + row.text(0) + " is done, but has no history", {});
}

void check_done_cases_have_results(Database& database, const ReportFinding& report) {
  Statement row = database.query(
      "SELECT id FROM cases LEFT JOIN results ON case_id = id WHERE state = 'done' AND case_id IS NULL");
  while (row.step())
    report("case " + row.text(0) + " is done, but has no result", [&, id = row.text(0)] {
      Transaction transaction(database);
      database.execute("UPDATE cases SET state = 'queued', message = 'its result was lost' WHERE id = ?", id);
      transaction.commit();
    });
}

void check_orphans(const std::filesystem::path& runs, Database& database, const ReportFinding& report) {
  for (const RunDirectory& orphan : orphaned_runs(runs, database)) {
    const std::string what = orphan.path().string() + " belongs to no case";
    if (orphan.is_worthless())
      report(what + " and holds nothing", [&] { std::filesystem::remove_all(orphan.path()); });
    else
      report(what + ": submit its study again, or delete it", {});
  }
}

void check_partial_files(const std::filesystem::path& runs, Database& database, const ReportFinding& report) {
  Statement row = database.query("SELECT id FROM cases WHERE state <> 'running'");
  while (row.step()) {
    const RunDirectory directory(runs / row.text(0));
    if (directory.has_partial_files())
      report(directory.path().string() + " holds half-written files",
             [&] { directory.remove_partial_files(); });
  }
}

}  // namespace

void check_runs(const std::filesystem::path& runs, Database& database, const ReportFinding& report) {
  check_results(runs, database, report);
  check_histories(runs, database, report);
  check_done_cases_have_histories(database, report);
  check_done_cases_have_results(database, report);
  check_orphans(runs, database, report);
  check_partial_files(runs, database, report);
}

}  // namespace capstan
