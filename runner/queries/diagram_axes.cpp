#include "runner/queries/diagram_axes.hpp"

#include <algorithm>
#include <set>

#include "runner/queries/typed_value.hpp"
#include "runner/study/shown_value.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

PhaseAxis sorted_axis(PhaseAxis axis) {
  const auto is_number = [](const json& value) { return value.is_number(); };
  if (std::all_of(axis.values.begin(), axis.values.end(), is_number))
    std::sort(axis.values.begin(), axis.values.end());
  axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
  return axis;
}

/// "0, 0.005, 0.015"; for more than kMaxNamed values, the first ones and the number of values.
std::string values_in_words(const std::vector<json>& values) {
  constexpr std::size_t kMaxNamed = 20;
  std::string words;
  for (std::size_t i = 0; i < std::min(values.size(), kMaxNamed); ++i)
    words += (i > 0 ? ", " : "") + shown_value(values[i]);
  return values.size() > kMaxNamed ? words + ", ... (" + std::to_string(values.size()) + " values)" : words;
}

/// Chooses the axes that are drawn and the values of the others.
class AxisChoice {
 public:
  AxisChoice(const ordered_json& study, Issues& issues) : issues_(issues) {
    for (const ordered_json& axis : study["axes"]) axes_.push_back(sorted_axis(axis_from_json(axis)));
  }

  PhaseDiagram read(const DiagramRequest& wanted) {
    for (const auto& [place, name] : {std::pair{"x", wanted.x}, std::pair{"y", wanted.y}})
      if (!name.empty() && !find(name)) add_issue(place, no_axis(name));
    if (!wanted.x.empty() && wanted.x == wanted.y)
      add_issue("y", "is " + wanted.x + " like x; name another axis");
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
  void add_issue(const std::string& place, const std::string& message) {
    issues_.push_back({place, message});
  }

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
    if (sign == std::string::npos)
      return add_issue("at", "\"" + text + "\" must be AXIS=VALUE, as in E_b=0.015");
    const std::string name = text.substr(0, sign), value = text.substr(sign + 1);
    const PhaseAxis* axis = find(name);
    if (!axis) return add_issue("at", no_axis(name));
    is_mentioned_.insert(name);
    if (name == wanted.x || name == wanted.y)
      return add_issue("at", name + " is drawn, so it cannot be fixed");
    const auto place = find_typed(axis->values, value);
    if (!place)
      return add_issue("at", name + " has no value " + value + "; it has: " + values_in_words(axis->values));
    if (!diagram.at.emplace(name, axis->values[*place]).second) add_issue("at", name + " is fixed twice");
  }

  /// The axis called `name`. If that is "": the first free axis with several values, else the first free
  /// axis.
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
      add_issue("at", axis.parameter + " is not fixed: say at which value, such as " + axis.parameter + "=" +
                          shown_value(axis.values[0]) + "; it has: " + values_in_words(axis.values));
  }

  std::vector<PhaseAxis> axes_;
  std::set<std::string> is_mentioned_;  ///< axes named by `at`, also if the value is unknown
  Issues& issues_;
};

}  // namespace

PhaseAxis axis_from_json(const ordered_json& given) {
  PhaseAxis axis{given["parameter"], {}};
  for (const ordered_json& value : given["values"]) axis.values.emplace_back(value);
  return axis;
}

PhaseDiagram choose_axes(const ordered_json& study, const DiagramRequest& wanted, Issues& issues) {
  return AxisChoice(study, issues).read(wanted);
}

}  // namespace capstan
