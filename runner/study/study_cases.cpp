#include "runner/study/study_cases.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "solver/case/case_warnings.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

using nlohmann::json;

/// A whole number without an exponent.
std::string whole(double number) {
  std::array<char, 400> text{};
  return {text.data(), std::to_chars(text.begin(), text.end(), number, std::chars_format::fixed, 0).ptr};
}

/// True for a value whose issues could be too many, or too long, to be collected again at each point.
bool is_large(const json& value) {
  constexpr std::size_t kMaxWord = 40;
  return value.is_structured() ||
         (value.is_string() && value.get_ref<const std::string&>().size() > kMaxWord);
}

/// Removes the value at the pointer, if there is one.
void erase_at(json& object, const std::string& pointer) {
  const json::json_pointer place(pointer);
  if (place.empty() || !object.contains(place)) return;
  object[place.parent_pointer()].erase(place.back());
}

/// Index of the axis that a pointer into a case belongs to; nothing if that is the base.
std::optional<std::size_t> axis_of(const std::string& case_pointer, const std::vector<Axis>& axes) {
  const std::string parameter = first_token(case_pointer);
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    if (axes[axis].parameter() == parameter) return axis;
  return std::nullopt;
}

/// The point's values on the axes that are lists. Ranges are left out: all values of a range share one
/// pointer.
std::vector<DroppedKeys::AxisValue> listed_values(const std::vector<Axis>& axes, const AxisIndices& indices) {
  std::vector<DroppedKeys::AxisValue> values;
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    if (axes[axis].is_list()) values.emplace_back(axis, indices[axis]);
  return values;
}

/// The value of a list that an issue belongs to; nothing if it belongs to the base or to a range.
std::optional<DroppedKeys::AxisValue> listed_value(const Issue& issue, const std::vector<Axis>& axes,
                                                   const AxisIndices& indices) {
  const auto axis = axis_of(issue.pointer, axes);
  if (!axis || !axes[*axis].is_list()) return std::nullopt;
  return DroppedKeys::AxisValue{*axis, indices[*axis]};
}

}  // namespace

void StudyCases::expand(Study& study) {
  double points = product_size(study.axes);
  const bool is_too_large = points > static_cast<double>(kMaxCases);
  if (is_too_large) {
    issues_.add(
        study.boundary ? "/boundary" : "/axes",
        "make a grid of " + whole(points) + " cases; at most " + std::to_string(kMaxCases) + " are allowed");
    points = 1;  // enough to find the issues of the base
  }
  std::map<std::string, std::size_t> numbers;  // index of each case, by its id
  for (std::size_t point = 0; static_cast<double>(point) < points; ++point) {
    const auto made = read_case(study.axes, axis_indices(study.axes, point));
    if (!made) continue;
    const auto [number, is_new] = numbers.emplace(case_id(*made), study.cases.size());
    if (is_new) study.cases.push_back(*made);
    study.points.push_back(number->second);
  }
  if (is_too_large) return;
  for (const Issue& issue : dropped_.issues()) issues_.add(issue.pointer, issue.message);
  study.notes = notes_on(study, dropped_, choices_, warnings_);
}

/// The case at one point; nothing if it has issues.
std::optional<Case> StudyCases::read_case(const std::vector<Axis>& axes, const AxisIndices& indices) {
  json flat = base_;
  std::set<std::string> left_out = invalid_axes_;  // parameters
  std::set<std::string> reported = invalid_axes_;  // parameters whose issues are known
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const std::string parameter = axes[axis].parameter();
    const json value = axes[axis].value(indices[axis]);
    const bool is_invalid = invalid_values_.contains({axis, indices[axis]});
    if (is_invalid) reported.insert(parameter);
    if (is_invalid && is_large(value))
      left_out.insert(parameter);
    else
      flat[parameter] = value;
  }
  // If a value is left out, it is not known which of the others have an effect.
  const ParsedCase parsed = left_out.empty() ? read_with_effect(flat, axes, indices) : parse_case(flat);
  for (const Issue& issue : parsed.issues)
    if (!reported.contains(first_token(issue.pointer)) && !issue.without_effect)
      add_issue(issue, axes, indices);
  for (const Choice& choice : parsed.choices) ++choices_[in_words(choice)];
  if (parsed.value)
    for (const std::string& warning : case_warnings(*parsed.value)) ++warnings_["warning: " + warning];
  return parsed.value;
}

/// Reads the case at a point after dropping the keys that have no effect there.
ParsedCase StudyCases::read_with_effect(json& flat, const std::vector<Axis>& axes,
                                        const AxisIndices& indices) {
  dropped_.count_point(listed_values(axes, indices));
  const auto is_useless = [](const Issue& issue) { return issue.without_effect; };
  ParsedCase parsed = parse_case(flat);
  for (; std::ranges::any_of(parsed.issues, is_useless); parsed = parse_case(flat))
    for (const Issue& issue : parsed.issues)
      if (is_useless(issue)) {
        dropped_.add(issue, study_pointer(issue.pointer, axes, indices), listed_value(issue, axes, indices));
        erase_at(flat, issue.pointer);
      }
  return parsed;
}

void StudyCases::add_issue(const Issue& issue, const std::vector<Axis>& axes, const AxisIndices& indices) {
  issues_.add(study_pointer(issue.pointer, axes, indices), issue.message);
  if (const auto axis = axis_of(issue.pointer, axes))
    invalid_values_.insert({*axis, indices[*axis]});
  else
    erase_at(base_, issue.pointer);
}

}  // namespace capstan
