#include "runner/doctor/database_checks.hpp"

namespace capstan {
namespace {

std::vector<std::string> first_column(Statement row) {
  std::vector<std::string> values;
  while (row.step()) values.push_back(row.text(0));
  return values;
}

/// The findings of one of SQLite's checks, which reports "ok" where there are none.
std::vector<std::string> damage_by(Database& database, const std::string& pragma) {
  std::vector<std::string> damage = first_column(database.query("PRAGMA " + pragma));
  std::erase(damage, "ok");
  return damage;
}

/// A quick check of all tables except `histories`, the largest one.
std::vector<std::string> quick_damage_without_histories(Database& database) {
  for (const std::string& table : first_column(
           database.query("SELECT name FROM sqlite_schema WHERE type = 'table' AND name <> 'histories'")))
    if (auto damage = damage_by(database, "quick_check(" + table + ")"); !damage.empty()) return damage;
  return {};
}

/// The quick check takes 2 s for 500 MB. It does not notice that a page of `histories` was overwritten by
/// another one. The integrity check does, because it also compares indices with their tables.
std::vector<std::string> damage_at_start(Database& database, std::uintmax_t bytes) {
  constexpr std::uintmax_t kMaxThorough = 200'000'000;
  constexpr std::uintmax_t kMaxWhole = 4'000'000'000;
  if (bytes <= kMaxThorough) return damage_by(database, "integrity_check(20)");
  return bytes <= kMaxWhole ? damage_by(database, "quick_check(3)")
                            : quick_damage_without_histories(database);
}

}  // namespace

void refuse_damaged_database(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  Database database(file, Database::Access::read);
  const std::vector<std::string> damage = damage_at_start(database, std::filesystem::file_size(file));
  if (!damage.empty())
    throw DatabaseDamaged("database " + file.string() + ": " + damage.front() + kWhatToDoAboutDamage);
}

std::vector<std::string> damage_of(Database& database) {
  std::vector<std::string> damage = damage_by(database, "integrity_check(20)");
  for (const std::string& table : first_column(database.query("PRAGMA foreign_key_check")))
    damage.push_back("a row of " + table + " refers to what is not there");
  return damage;
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
