#include "runner/store/history_columns.hpp"

#include <set>

#include "solver/run_directory/history_line.hpp"

namespace capstan {
namespace {

std::set<std::string> existing_columns(Database& database) {
  std::set<std::string> names;
  Statement row = database.query("SELECT name FROM pragma_table_info('histories')");
  while (row.step()) names.insert(row.text(0));
  return names;
}

}  // namespace

const std::vector<std::string>& history_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> names;
    for (const Observable& observable : kObservables)
      if (observable.is_in_database) names.emplace_back(observable.name);
    return names;
  }();
  return columns;
}

std::string history_columns_in(Database& database) {
  const std::set<std::string> existing = existing_columns(database);
  std::string list;
  for (const std::string& name : history_columns())
    list += (list.empty() ? "" : ", ") + (existing.contains(name) ? name : "NULL");
  return list;
}

void add_history_columns(Database& database) {
  const std::set<std::string> existing = existing_columns(database);
  for (const std::string& name : history_columns())
    if (!existing.contains(name)) database.execute("ALTER TABLE histories ADD COLUMN " + name + " REAL");
}

}  // namespace capstan
