#include "runner/store/upgrade.hpp"

#include <string>

#include "runner/store/database.hpp"
#include "runner/store/history_columns.hpp"
#include "runner/store/schema.hpp"

namespace capstan {
namespace {

std::size_t format_of(Database& database) {
  Statement version = database.query("PRAGMA user_version");
  version.step();
  return static_cast<std::size_t>(version.integer(0));
}

}  // namespace

void upgrade_to_present_format(Database& database) {
  Transaction transaction(database);
  const auto steps = migrations();
  const std::size_t found = format_of(database);
  if (found > steps.size())
    throw DatabaseError("the database has format " + std::to_string(found) + ", this program reads format " +
                        std::to_string(steps.size()));
  if (found == 0) database.execute_script(kQueueTables);
  if (found > 0 && found < steps.size()) {
    for (const char* step : steps.subspan(found)) database.execute_script(step);
    database.execute_script(kRecount);
  }
  if (found < steps.size())
    database.execute_script(("PRAGMA user_version = " + std::to_string(steps.size())).c_str());
  add_history_columns(database);
  transaction.commit();
}

}  // namespace capstan
