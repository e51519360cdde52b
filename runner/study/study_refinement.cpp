#include "runner/study/study_refinement.hpp"

#include <algorithm>
#include <cmath>

namespace capstan {
namespace {

using nlohmann::json;

std::string pointer_to(const std::string& key) { return (json::json_pointer("/refine") / key).to_string(); }

const Axis* find_axis(const std::vector<Axis>& axes, const std::string& parameter) {
  const auto found =
      std::ranges::find_if(axes, [&](const Axis& axis) { return axis.parameter() == parameter; });
  return found == axes.end() ? nullptr : &*found;
}

/// Smallest and largest value; nothing if a value is no number, or if there is only one.
std::optional<std::pair<double, double>> ends_of(const Axis& axis) {
  constexpr double kMaxValues = 10000;
  if (axis.size() < 2 || axis.size() > kMaxValues) return std::nullopt;
  std::vector<double> values;
  for (std::size_t i = 0; static_cast<double>(i) < axis.size(); ++i) {
    const json value = axis.value(i);
    if (!value.is_number()) return std::nullopt;
    values.push_back(value);
  }
  const auto [least, largest] = std::ranges::minmax_element(values);
  return std::pair{*least, *largest};
}

/// Adds the issues of one axis. A side may not be so small that a grid of such cells has too many values.
void check_side(const std::string& parameter, const json& side, const std::vector<Axis>& axes,
                IssueCollector& issues) {
  constexpr double kMaxCells = 1000;
  const Axis* axis = find_axis(axes, parameter);
  const auto ends = axis ? ends_of(*axis) : std::nullopt;
  if (!ends) return issues.add(pointer_to(parameter), "is no axis of the study with several numbers");
  const double least = (ends->second - ends->first) / kMaxCells;
  if (!side.is_number() || !std::isfinite(side.get<double>()) || side.get<double>() < least)
    issues.add(pointer_to(parameter),
               "must be the side of the smallest cell, at least " + json(least).dump());
}

}  // namespace

std::optional<StudyRefinement> read_refinement(const json& given, const std::vector<Axis>& axes,
                                               IssueCollector& issues) {
  if (!given.is_object() || given.size() != 2) {
    issues.add("/refine",
               "must name two axes with the sides of the smallest cells, as {\"Ca\": 0.02, \"V\": 0.25}");
    return std::nullopt;
  }
  for (const auto& [parameter, side] : given.items()) check_side(parameter, side, axes, issues);
  StudyRefinement refinement;
  std::size_t number = 0;
  for (const Axis& axis : axes)
    if (given.contains(axis.parameter()) && given[axis.parameter()].is_number() && number < 2) {
      refinement.axes[number] = axis.parameter();
      refinement.sides[number++] = given[axis.parameter()];
    }
  return number == 2 ? std::optional(refinement) : std::nullopt;
}

std::optional<StudyRefinement> refinement_of(const json& document) {
  if (!document.contains("refine")) return std::nullopt;
  Issues issues;
  std::vector<Axis> axes;
  for (const std::string_view name : axis_parameters()) {
    const std::string parameter(name);
    if (!document["axes"].contains(parameter)) continue;
    if (auto axis = read_axis(parameter, document["axes"][parameter], "/axes/" + parameter, issues))
      axes.push_back(std::move(*axis));
  }
  IssueCollector collector(issues);
  return read_refinement(document["refine"], axes, collector);
}

}  // namespace capstan
