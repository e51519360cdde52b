#include "runner/queries/phase_diagram.hpp"

#include <algorithm>

#include "runner/queries/diagram_axes.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// Index of each value on an axis.
using Places = std::map<json, std::size_t>;

Places places_on(const PhaseAxis& axis) {
  Places places;
  for (std::size_t i = 0; i < axis.values.size(); ++i) places.emplace(axis.values[i], i);
  return places;
}

/// Nothing if the axis has no such value.
std::optional<std::size_t> place_of(const PointMotion& point, const std::string& parameter,
                                    const Places& places) {
  const auto found = places.find(parameter.empty() ? json() : point.asked.value(parameter, json()));
  return found == places.end() ? std::nullopt : std::optional(found->second);
}

bool stands_at(const PointMotion& point, const std::map<std::string, json>& at) {
  return std::all_of(at.begin(), at.end(), [&](const auto& fixed) {
    return point.asked.value(fixed.first, json()) == fixed.second;
  });
}

/// Combines the motions or the states of two points: "mixed" if they differ; "" is ignored.
void merge(std::string& all, const std::string& one) {
  if (all.empty())
    all = one;
  else if (all != one && !one.empty())
    all = "mixed";
}

void add_point(PhaseCell& cell, const PointMotion& point) {
  merge(cell.motion, point.motion);
  merge(cell.state, point.state);
  cell.cases.push_back(point.case_id);
  cell.is_confirmed = cell.is_confirmed && point.is_confirmed;
}

ordered_json to_json(const PhaseAxis& axis) {
  return {{"parameter", axis.parameter}, {"values", axis.values}};
}

}  // namespace

ParsedDiagram phase_diagram(const ordered_json& study, const std::vector<PointMotion>& points,
                            const DiagramRequest& wanted) {
  ParsedDiagram parsed;
  PhaseDiagram diagram = choose_axes(study, wanted, parsed.issues);
  if (!parsed.issues.empty()) return parsed;
  const Places columns = places_on(diagram.x), rows = places_on(diagram.y);
  diagram.rows.assign(diagram.y.values.size(), std::vector<PhaseCell>(diagram.x.values.size()));
  for (const PointMotion& point : points) {
    const auto column = place_of(point, diagram.x.parameter, columns);
    const auto row = place_of(point, diagram.y.parameter, rows);
    if (column && row && stands_at(point, diagram.at)) add_point(diagram.rows[*row][*column], point);
  }
  parsed.value = std::move(diagram);
  return parsed;
}

ordered_json to_json(const PhaseDiagram& diagram) {
  ordered_json rows = ordered_json::array();
  for (const auto& cells : diagram.rows) {
    ordered_json row = ordered_json::array();
    for (const PhaseCell& cell : cells)
      row.push_back({{"motion", cell.motion.empty() ? ordered_json() : ordered_json(cell.motion)},
                     {"state", cell.state},
                     {"cases", cell.cases},
                     {"confirmed", cell.motion.empty() ? ordered_json() : ordered_json(cell.is_confirmed)}});
    rows.push_back(row);
  }
  return {{"x", to_json(diagram.x)}, {"y", to_json(diagram.y)}, {"at", diagram.at}, {"rows", rows}};
}

PhaseDiagram phase_diagram_from_json(const ordered_json& document) {
  PhaseDiagram diagram{axis_from_json(document["x"]), axis_from_json(document["y"]), {}, {}};
  for (const auto& [parameter, value] : document["at"].items()) diagram.at.emplace(parameter, value);
  for (const ordered_json& row : document["rows"]) {
    auto& cells = diagram.rows.emplace_back();
    for (const ordered_json& cell : row)
      cells.push_back({cell["motion"].is_string() ? cell["motion"].get<std::string>() : "", cell["state"],
                       cell["cases"].get<std::vector<std::string>>(), cell["confirmed"] == true});
  }
  return diagram;
}

}  // namespace capstan
