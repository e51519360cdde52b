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

Table diagram_table(const PhaseDiagram& diagram) {
  Table table;
  for (const auto& [parameter, value] : diagram.at) table.columns.push_back(parameter);
  const bool has_y = !diagram.y.parameter.empty();
  if (has_y) table.columns.push_back(diagram.y.parameter);
  for (const std::string& column : {diagram.x.parameter, std::string("motion"), std::string("confirmed"),
                                    std::string("state"), std::string("case")})
    table.columns.push_back(column);
  for (std::size_t j = 0; j < diagram.rows.size(); ++j)
    for (std::size_t i = 0; i < diagram.rows[j].size(); ++i) {
      const PhaseCell& cell = diagram.rows[j][i];
      for (const std::string& id : cell.cases) {
        std::vector<ordered_json> row;
        for (const auto& [parameter, value] : diagram.at) row.emplace_back(value);
        if (has_y) row.emplace_back(diagram.y.values[j]);
        row.emplace_back(diagram.x.values[i]);
        row.insert(row.end(), {cell.motion, cell.is_confirmed, cell.state, id});
        table.rows.push_back(std::move(row));
      }
    }
  return table;
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

Table histories_table(const ordered_json& study, const TimeGrid& grid,
                      const std::vector<std::string>& columns, const ordered_json& points) {
  Table table{{"point"}, {}};
  for (const ordered_json& axis : study["axes"]) table.columns.push_back(axis["parameter"]);
  table.columns.emplace_back("kt");
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  for (const ordered_json& point : points)
    for (std::size_t i = 0; i < grid.size; ++i) {
      std::vector<ordered_json>& row = table.rows.emplace_back();
      row.push_back(point["point"]);
      for (const ordered_json& axis : study["axes"]) row.push_back(point["asked"][axis["parameter"]]);
      row.emplace_back(grid.time(i));
      for (const std::string& name : columns) row.push_back(point["history"][name][i]);
    }
  return table;
}

}  // namespace capstan
