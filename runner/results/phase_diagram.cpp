#include "runner/results/phase_diagram.hpp"

#include <algorithm>

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// The axis of that name, or else the first one that is not taken. Fidelity is no axis here: its cases share
/// points.
std::optional<PhaseAxis> choose_axis(const ordered_json& axes, const std::string& name,
                                     const std::string& taken) {
  for (const ordered_json& axis : axes) {
    const std::string parameter = axis["parameter"];
    if (parameter == "fidelity" || parameter == taken || (!name.empty() && parameter != name)) continue;
    PhaseAxis chosen{parameter, axis["values"].get<std::vector<ordered_json>>()};
    const auto is_number = [](const ordered_json& value) { return value.is_number(); };
    if (std::all_of(chosen.values.begin(), chosen.values.end(), is_number))
      std::sort(chosen.values.begin(), chosen.values.end());
    chosen.values.erase(std::unique(chosen.values.begin(), chosen.values.end()), chosen.values.end());
    return chosen;
  }
  return std::nullopt;
}

/// Which value of the axis a case has; nothing if the axis has no such value.
std::optional<std::size_t> position(const PhaseAxis& axis, const ordered_json& parameters) {
  if (axis.parameter.empty()) return 0;
  if (!parameters.contains(axis.parameter)) return std::nullopt;
  const ordered_json value = parameters[axis.parameter];
  const auto found = std::find(axis.values.begin(), axis.values.end(), value);
  if (found == axis.values.end()) return std::nullopt;
  return static_cast<std::size_t>(found - axis.values.begin());
}

void merge(std::string& all, const std::string& one) {
  if (all.empty())
    all = one;
  else if (all != one && !one.empty())
    all = "mixed";
}

void add_case(PhaseCell& cell, const ordered_json& shown) {
  merge(cell.motion, shown["motion"].is_string() ? shown["motion"].get<std::string>() : "");
  merge(cell.state, shown["state"]);
  cell.cases.push_back(shown["id"]);
}

ordered_json to_json(const PhaseAxis& axis) {
  return {{"parameter", axis.parameter}, {"values", axis.values}};
}

PhaseAxis axis_from_json(const ordered_json& axis) {
  return {axis["parameter"], axis["values"].get<std::vector<ordered_json>>()};
}

}  // namespace

std::optional<PhaseDiagram> phase_diagram(const ordered_json& study, const ordered_json& cases,
                                          const std::string& x, const std::string& y) {
  const auto first = choose_axis(study["axes"], x, y);
  if (!first) return std::nullopt;
  const auto second = choose_axis(study["axes"], y, first->parameter);
  if (!second && !y.empty()) return std::nullopt;
  PhaseDiagram diagram{*first, second.value_or(PhaseAxis{"", {nullptr}}), {}};
  diagram.rows.assign(diagram.y.values.size(), std::vector<PhaseCell>(diagram.x.values.size()));
  for (const ordered_json& shown : cases) {
    const auto column = position(diagram.x, shown["parameters"]);
    const auto row = position(diagram.y, shown["parameters"]);
    if (column && row) add_case(diagram.rows[*row][*column], shown);
  }
  return diagram;
}

ordered_json to_json(const PhaseDiagram& diagram) {
  ordered_json rows = ordered_json::array();
  for (const auto& cells : diagram.rows) {
    ordered_json row = ordered_json::array();
    for (const PhaseCell& cell : cells)
      row.push_back({{"motion", cell.motion.empty() ? ordered_json() : ordered_json(cell.motion)},
                     {"state", cell.state},
                     {"cases", cell.cases}});
    rows.push_back(row);
  }
  return {{"x", to_json(diagram.x)}, {"y", to_json(diagram.y)}, {"rows", rows}};
}

PhaseDiagram phase_diagram_from_json(const ordered_json& json) {
  PhaseDiagram diagram{axis_from_json(json["x"]), axis_from_json(json["y"]), {}};
  for (const ordered_json& row : json["rows"]) {
    auto& cells = diagram.rows.emplace_back();
    for (const ordered_json& cell : row)
      cells.push_back({cell["motion"].is_string() ? cell["motion"].get<std::string>() : "", cell["state"],
                       cell["cases"].get<std::vector<std::string>>()});
  }
  return diagram;
}

}  // namespace capstan
