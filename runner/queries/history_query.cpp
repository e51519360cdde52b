#include <algorithm>
#include <cmath>

#include "runner/queries/queries.hpp"
#include "runner/recording/history.hpp"
#include "runner/store/history_columns.hpp"

namespace capstan {

using nlohmann::ordered_json;

namespace {

ordered_json number_or_null(double number) {
  return std::isnan(number) ? ordered_json() : ordered_json(number);
}

/// \param names  of observables
ordered_json columns_of(const History& history, const std::vector<std::string>& names) {
  ordered_json columns;
  for (const std::string& name : names) {
    const auto* const found = std::ranges::find(kObservables, name, &Observable::name);
    const ObservableRow row(static_cast<std::size_t>(found - std::begin(kObservables)));
    ordered_json& column = columns[name] = ordered_json::array();
    for (const Record& record : history) column.push_back(number_or_null(record[row]));
  }
  return columns;
}

}  // namespace

std::optional<ordered_json> find_history(Database& database, const std::string& case_id) {
  if (!database.query("SELECT 1 FROM cases WHERE id = ?", case_id).step()) return std::nullopt;
  return columns_of(stored_history(database, case_id), history_columns());
}

Page find_histories(Database& database, const std::string& study_id, const TimeGrid& grid,
                    const std::vector<std::string>& columns, const CaseFilter& filter,
                    const PageRequest& wanted) {
  Page page = find_cases(database, study_id, filter, wanted);
  for (ordered_json& point : page.items) {
    const History history = on_grid(stored_history(database, point["id"]), grid);
    point = {{"point", point["point"]},
             {"id", point["id"]},
             {"asked", point["asked"]},
             {"history", columns_of(history, columns)}};
  }
  return page;
}

}  // namespace capstan
