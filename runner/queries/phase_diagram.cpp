#include "runner/queries/phase_diagram.hpp"

#include <algorithm>
#include <set>

#include "runner/queries/typed_value.hpp"
#include "runner/study/shown_value.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

PhaseAxis axis_from_json(const ordered_json& given) {
  PhaseAxis axis{given["parameter"], {}};
  for (const ordered_json& value : given["values"]) axis.values.emplace_back(value);
  return axis;
}

PhaseAxis sorted_axis(PhaseAxis axis) {
  const auto is_number = [](const json& value) { return value.is_number(); };
  if (std::all_of(axis.values.begin(), axis.values.end(), is_number))
    std::sort(axis.values.begin(), axis.values.end());
  axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
  return axis;
}

/// "0, 0.005, 0.015"; of many values the first ones and how many there are.
std::string values_in_words(const std::vector<json>& values) {
  constexpr std::size_t kMaxNamed = 20;
  std::string words;
  for (std::size_t i = 0; i < std::min(values.size(), kMaxNamed); ++i)
    words += (i > 0 ? ", " : "") + shown_value(values[i]);
  return values.size() > kMaxNamed ? words + ", ... (" + std::to_string(values.size()) + " values)" : words;
}

/// Finds out which axes are drawn and where the others are fixed.
class DiagramReader {
 public:
  DiagramReader(const ordered_json& study, Issues& issues) : issues_(issues) {
    for (const ordered_json& axis : study["axes"]) axes_.push_back(sorted_axis(axis_from_json(axis)));
  }

  PhaseDiagram read(const DiagramRequest& wanted) {
    for (const auto& [place, name] : {std::pair{"x", wanted.x}, std::pair{"y", wanted.y}})
      if (!name.empty() && !find(name)) fault(place, no_axis(name));
    if (!wanted.x.empty() && wanted.x == wanted.y)
      fault("y", "is " + wanted.x + " like x; name another axis");
    PhaseDiagram diagram;
    if (!issues_.empty()) return diagram;
    for (const std::string& text : wanted.at) fix(text, wanted, diagram);
    diagram.x = chosen(wanted.x, wanted.y, diagram);
    diagram.y = chosen(wanted.y, diagram.x.parameter, diagram);
    for (const PhaseAxis& axis : axes_)
      if (axis.parameter != diagram.x.parameter && axis.parameter != diagram.y.parameter)
        require_fixed(axis, diagram);
    return diagram;
  }

 private:
  void fault(const std::string& place, const std::string& message) { issues_.push_back({place, message}); }

  const PhaseAxis* find(const std::string& name) const {
    const auto found = std::find_if(axes_.begin(), axes_.end(),
                                    [&](const PhaseAxis& axis) { return axis.parameter == name; });
    return found == axes_.end() ? nullptr : &*found;
  }

  std::string no_axis(const std::string& name) const {
    std::string names;
    for (const PhaseAxis& axis : axes_) names += (names.empty() ? "" : ", ") + axis.parameter;
    return "\"" + name + "\" is no axis of the study; its axes are: " + names;
  }

  void fix(const std::string& text, const DiagramRequest& wanted, PhaseDiagram& diagram) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos) return fault("at", "\"" + text + "\" must be AXIS=VALUE, as in E_b=0.015");
    const std::string name = text.substr(0, sign), value = text.substr(sign + 1);
    const PhaseAxis* axis = find(name);
    if (!axis) return fault("at", no_axis(name));
    is_mentioned_.insert(name);
    if (name == wanted.x || name == wanted.y) return fault("at", name + " is drawn, so it cannot be fixed");
    const auto place = find_typed(axis->values, value);
    if (!place)
      return fault("at", name + " has no value " + value + "; it has: " + values_in_words(axis->values));
    if (!diagram.at.emplace(name, axis->values[*place]).second) fault("at", name + " is fixed twice");
  }

  /// The axis of that name; without a name the first free one that has more than one value, or else any free
  /// one.
  PhaseAxis chosen(const std::string& name, const std::string& taken, const PhaseDiagram& diagram) const {
    if (const PhaseAxis* axis = find(name)) return *axis;
    const auto is_free = [&](const PhaseAxis& axis) {
      return axis.parameter != taken && !diagram.at.contains(axis.parameter);
    };
    const auto varies = [&](const PhaseAxis& axis) { return is_free(axis) && axis.values.size() > 1; };
    auto found = std::find_if(axes_.begin(), axes_.end(), varies);
    if (found == axes_.end()) found = std::find_if(axes_.begin(), axes_.end(), is_free);
    return found == axes_.end() ? PhaseAxis{"", {nullptr}} : *found;
  }

  void require_fixed(const PhaseAxis& axis, PhaseDiagram& diagram) {
    if (diagram.at.contains(axis.parameter) || is_mentioned_.contains(axis.parameter)) return;
    if (axis.values.size() == 1)
      diagram.at[axis.parameter] = axis.values[0];
    else
      fault("at", axis.parameter + " is not fixed: say at which value, as in at=" + axis.parameter + "=" +
                      shown_value(axis.values[0]) + "; it has: " + values_in_words(axis.values));
  }

  std::vector<PhaseAxis> axes_;
  std::set<std::string> is_mentioned_;  ///< axes that `at` names, also with a value that they do not have
  Issues& issues_;
};

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
}

ordered_json to_json(const PhaseAxis& axis) {
  return {{"parameter", axis.parameter}, {"values", axis.values}};
}

}  // namespace

ParsedDiagram phase_diagram(const ordered_json& study, const std::vector<PointMotion>& points,
                            const DiagramRequest& wanted) {
  ParsedDiagram parsed;
  PhaseDiagram diagram = DiagramReader(study, parsed.issues).read(wanted);
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
                     {"cases", cell.cases}});
    rows.push_back(row);
  }
  return {{"x", to_json(diagram.x)}, {"y", to_json(diagram.y)}, {"at", diagram.at}, {"rows", rows}};
}

PhaseDiagram phase_diagram_from_json(const ordered_json& json) {
  PhaseDiagram diagram{axis_from_json(json["x"]), axis_from_json(json["y"]), {}, {}};
  for (const auto& [parameter, value] : json["at"].items()) diagram.at.emplace(parameter, value);
  for (const ordered_json& row : json["rows"]) {
    auto& cells = diagram.rows.emplace_back();
    for (const ordered_json& cell : row)
      cells.push_back({cell["motion"].is_string() ? cell["motion"].get<std::string>() : "", cell["state"],
                       cell["cases"].get<std::vector<std::string>>()});
  }
  return diagram;
}

}  // namespace capstan
