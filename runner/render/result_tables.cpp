#include "runner/render/result_tables.hpp"

#include "runner/render/result_columns.hpp"

namespace capstan {

using nlohmann::ordered_json;

Table summary_table(const ordered_json& study, const ordered_json& cases) {
  ResultColumns columns;
  columns.look_at(cases);
  return table_of(cases, columns.summary(study));
}

Table full_table(const ordered_json& cases) {
  ResultColumns columns;
  columns.look_at(cases);
  return table_of(cases, columns.all());
}

Table history_table(const ordered_json& history) {
  Table table;
  for (const auto& [name, values] : history.items()) {
    table.columns.push_back(name);
    table.rows.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) table.rows[i].push_back(values[i]);
  }
  return table;
}

}  // namespace capstan
