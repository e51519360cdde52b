#include "runner/doctor/database_checks.hpp"

namespace capstan {
namespace {

std::vector<std::string> first_column(Statement row) {
  std::vector<std::string> values;
  while (row.step()) values.push_back(row.text(0));
  return values;
}

/// All that `quick_check` says of the whole database, or of one table and its indices, but "ok".
std::vector<std::string> quick_faults(Database& database, const std::string& table = "") {
  constexpr const char* kMax = "3";
  std::vector<std::string> faults =
      first_column(database.query("PRAGMA quick_check(" + (table.empty() ? kMax : table) + ")"));
  std::erase(faults, "ok");
  return faults;
}

std::vector<std::string> integrity_faults(Database& database) {
  std::vector<std::string> faults = first_column(database.query("PRAGMA integrity_check(20)"));
  std::erase(faults, "ok");
  return faults;
}

std::vector<std::string> quick_faults_but_of_histories(Database& database) {
  for (const std::string& table : first_column(
           database.query("SELECT name FROM sqlite_schema WHERE type = 'table' AND name <> 'histories'")))
    if (auto faults = quick_faults(database, table); !faults.empty()) return faults;
  return {};
}

/// The quick check does not see that a page of histories stands in the place of another one.
std::vector<std::string> faults_at_start(Database& database, std::uintmax_t bytes) {
  constexpr std::uintmax_t kMaxWhole = 4'000'000'000;  // 500 MB take 2 s
  constexpr std::uintmax_t kMaxThorough = 200'000'000;
  if (bytes <= kMaxThorough) return integrity_faults(database);
  return bytes <= kMaxWhole ? quick_faults(database) : quick_faults_but_of_histories(database);
}

}  // namespace

void refuse_damaged_database(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  Database database(file, Database::Access::read);
  const std::vector<std::string> faults = faults_at_start(database, std::filesystem::file_size(file));
  if (!faults.empty())
    throw DatabaseDamaged("database " + file.string() + ": " + faults.front() + kWhatToDoAboutDamage);
}

std::vector<std::string> damage_of(Database& database) {
  std::vector<std::string> faults = integrity_faults(database);
  for (const std::string& table : first_column(database.query("PRAGMA foreign_key_check")))
    faults.push_back("a row of " + table + " refers to what is not there");
  return faults;
}

std::vector<std::string> miscounted_studies(Database& database) {
  return first_column(database.query(
      "WITH c AS ("
      " SELECT study_id, sum(state = 'queued') queued, sum(state = 'running') running, sum(state = 'done') "
      "done,"
      " sum(state = 'failed') failed, sum(state = 'diverged') diverged, sum(state = 'cancelled') cancelled,"
      " sum(cost) cost_total, sum(cost * (state NOT IN ('queued', 'running', 'cancelled'))) cost_ended"
      " FROM (SELECT DISTINCT study_id, case_id FROM study_cases) w JOIN cases ON id = w.case_id GROUP BY "
      "study_id),"
      " p AS ("
      " SELECT study_id, count(*) points,"
      " sum(motion IS 'tumbling') tumbling, sum(motion IS 'tank_treading') tank_treading,"
      " sum(motion IS 'transition') transition, sum(motion IS 'undecided') undecided"
      " FROM study_cases w LEFT JOIN results r ON r.case_id = w.case_id GROUP BY study_id)"
      " SELECT s.study_id FROM schedule s JOIN c USING (study_id) JOIN p USING (study_id)"
      " WHERE (s.queued, s.running, s.done, s.failed, s.diverged, s.cancelled, s.points, s.tumbling,"
      " s.tank_treading, s.transition, s.undecided) IS NOT"
      " (c.queued, c.running, c.done, c.failed, c.diverged, c.cancelled, p.points, p.tumbling,"
      " p.tank_treading, p.transition, p.undecided)"
      // sums of costs are kept by adding and taking away, which is not exact
      " OR max(abs(s.cost_total - c.cost_total), abs(s.cost_ended - c.cost_ended)) > 1e-6 * c.cost_total"
      " UNION SELECT s.id FROM studies s WHERE cancelled_at IS NULL AND"
      " (SELECT count(*) FROM study_cases w JOIN cases c ON c.id = w.case_id"
      "  WHERE w.study_id = s.id AND c.state = 'queued') <>"
      " (SELECT count(*) FROM waiting WHERE study_number = s.number)"));
}

}  // namespace capstan
