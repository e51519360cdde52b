#include <cmath>

#include "runner/queries/queries.hpp"
#include "runner/recording/history.hpp"

namespace capstan {

using nlohmann::ordered_json;

namespace {

ordered_json number_or_null(double number) {
  return std::isnan(number) ? ordered_json() : ordered_json(number);
}

}  // namespace

std::optional<ordered_json> find_history(Database& database, const std::string& case_id) {
  if (!database.query("SELECT 1 FROM cases WHERE id = ?", case_id).step()) return std::nullopt;
  const History history = stored_history(database, case_id);
  ordered_json columns;
  for (std::size_t i = 0; i < kObservableCount; ++i) {
    if (!kObservables[i].is_in_database) continue;
    ordered_json& column = columns[std::string(kObservables[i].name)] = ordered_json::array();
    for (const Record& record : history) column.push_back(number_or_null(record.values[i]));
  }
  return columns;
}

}  // namespace capstan
