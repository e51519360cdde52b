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

/// Summed costs are kept by adding and subtracting, which is not exact.
std::vector<std::string> miscounted_studies(Database& database) {
  return first_column(
      database.query("WITH total AS (SELECT study_id, sum(cost) cost FROM counted_tallies GROUP BY study_id)"
                     " SELECT study_id FROM counted_tallies c FULL JOIN tallies t USING (study_id, word)"
                     " LEFT JOIN total USING (study_id)"
                     " WHERE ifnull(c.count, 0) <> ifnull(t.count, 0)"
                     " OR abs(ifnull(c.cost, 0) - ifnull(t.cost, 0)) > 1e-6 * total.cost"
                     " UNION SELECT s.id FROM studies s JOIN schedule USING (number)"
                     " WHERE waiting <> (SELECT count(*) FROM waiting w WHERE w.study_number = s.number)"
                     " OR waiting <> (s.cancelled_at IS NULL) * (SELECT count(*) FROM study_cases p"
                     "  JOIN cases c ON c.id = p.case_id WHERE p.study_id = s.id AND c.state = 'queued')"));
}

}  // namespace capstan
