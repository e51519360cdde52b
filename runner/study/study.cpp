#include "runner/study/study.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

#include "runner/study/dropped_keys.hpp"
#include "runner/study/expand.hpp"
#include "runner/study/study_notes.hpp"
#include "solver/case/case_warnings.hpp"
#include "solver/case/content_id.hpp"
#include "solver/case/mistyped_keys.hpp"

namespace capstan {
namespace {

using nlohmann::json;

std::string pointer_to(const std::string& object, const std::string& key) {
  return (json::json_pointer(object) / key).to_string();
}

std::string whole(double number) {
  std::array<char, 400> text{};
  return {text.data(), std::to_chars(text.begin(), text.end(), number, std::chars_format::fixed, 0).ptr};
}

/// The axis that a fault of an expanded case belongs to; nothing if it is one of the base.
std::optional<std::size_t> axis_of(const std::string& case_pointer, const std::vector<Axis>& axes) {
  const std::string parameter = first_token(case_pointer);
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    if (axes[axis].parameter() == parameter) return axis;
  return std::nullopt;
}

/// Its faults are too many, or too long, to be found again at each point.
bool is_large(const json& value) {
  constexpr std::size_t kMaxWord = 40;
  return value.is_structured() ||
         (value.is_string() && value.get_ref<const std::string&>().size() > kMaxWord);
}

/// Takes out what stands at the pointer, if anything does.
void erase_at(json& object, const std::string& pointer) {
  const json::json_pointer place(pointer);
  if (place.empty() || !object.contains(place)) return;
  object[place.parent_pointer()].erase(place.back());
}

/// The first faults tell what to do; a list of all could be larger than the document.
void limit_number(Issues& issues) {
  constexpr std::size_t kMaxReported = 100;
  if (issues.size() <= kMaxReported) return;
  const std::size_t more = issues.size() - kMaxReported;
  issues.resize(kMaxReported);
  issues.push_back({"", "and " + std::to_string(more) + " more faults"});
}

/// 4.0 becomes 4 and -0.0 becomes 0, so that one study in two spellings is one document.
void spell_numbers_alike(json& value) {
  constexpr double kMaxWhole = 9007199254740992;  // 2^53: up to here a double holds every whole number
  if (value.is_structured())
    for (json& inner : value) spell_numbers_alike(inner);
  if (!value.is_number_float()) return;
  const double number = value;
  if (number == std::floor(number) && std::abs(number) <= kMaxWhole)
    value = static_cast<std::int64_t>(number);
}

/// So that a mistyped key is one fault, and what it was meant to be is not missing.
Issues rename_mistyped_keys_of_study(json& document) {
  Issues issues = rename_mistyped_keys(document, {"name", "description", "base", "axes"});
  for (const auto& [group, known] : {std::pair{"base", case_keys()}, std::pair{"axes", axis_parameters()}})
    if (document.contains(group)) {
      const Issues more = rename_mistyped_keys(document[group], known, std::string("/") + group);
      issues.insert(issues.end(), more.begin(), more.end());
    }
  return issues;
}

/// Reads one document; what is wrong with it gathers in `issues`, at most one fault a pointer.
class StudyReader {
 public:
  StudyReader(const json& document, Issues& issues) : document_(document), issues_(issues) {}

  Study read() {
    Study study;
    study.document = document_;
    study.name = read_name();
    study.description = read_description();
    study.axes = read_axes();
    refuse_unknown_keys();
    if (const json* base = read_base()) expand(*base, study);
    return study;
  }

 private:
  void fault(const std::string& pointer, const std::string& message) {
    if (faulty_.insert(pointer).second) issues_.push_back({pointer, message});
  }

  /// The name is a part of the study's id, which people type.
  std::string read_name() {
    const json name = document_.value("name", json());
    const std::string text = name.is_string() ? name.get<std::string>() : "";
    const auto allowed = [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '-' || c == '_'); };
    if (text.empty() || text.size() > 40 || !std::all_of(text.begin(), text.end(), allowed))
      fault("/name", "must be 1 to 40 letters, digits, '-' or '_'");
    return text;
  }

  std::string read_description() {
    const json description = document_.value("description", json(""));
    if (description.is_string()) return description.get<std::string>();
    fault("/description", std::string("must be text, is ") + description.type_name());
    return "";
  }

  void refuse_unknown_keys() {
    static const std::set<std::string> known = {"name", "description", "base", "axes"};
    for (const auto& [key, value] : document_.items())
      if (!known.contains(key)) fault(pointer_to("", key), "unknown key");
  }

  std::vector<Axis> read_axes() {
    std::vector<Axis> axes;
    const json given = document_.value("axes", json::object());
    if (!given.is_object()) {
      fault("/axes", std::string("must be an object, is ") + given.type_name());
      return axes;
    }
    for (const std::string_view name : axis_parameters()) {
      const std::string parameter(name);
      if (!given.contains(parameter)) continue;
      if (auto axis = read_axis(parameter, given[parameter], issues_))
        axes.push_back(std::move(*axis));
      else
        faulty_axes_.insert(parameter);
    }
    refuse_other_axes(given);
    return axes;
  }

  void refuse_other_axes(const json& given) {
    const auto& known = axis_parameters();
    std::string names;
    for (const std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    for (const auto& [key, value] : given.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        fault(pointer_to("/axes", key), "cannot be an axis; these can: " + names);
  }

  const json* read_base() {
    const auto base = document_.find("base");
    if (base == document_.end())
      fault("/base", "is missing: the case that the axes vary");
    else if (!base->is_object())
      fault("/base", std::string("must be an object, is ") + base->type_name());
    if (faulty_.contains("/base")) return nullptr;
    const auto axes = document_.find("axes");  // as they stand there: a faulty axis is one, too
    if (axes != document_.end() && axes->is_object())
      for (const auto& [parameter, values] : axes->items())
        if (base->contains(parameter)) fault(pointer_to("/base", parameter), "is an axis, too");
    return &*base;
  }

  /// A key of the base or a large value of an axis at which a fault was found is not tried again: so the time
  /// grows with the document and with the number of cases, not with their product. A small value stays: what
  /// depends on it is then no fault of its own.
  void expand(json base, Study& study) {
    double points = product_size(study.axes);
    const bool is_too_large = points > static_cast<double>(kMaxCases);
    if (is_too_large) {
      fault("/axes", "make a grid of " + whole(points) + " cases; at most " + std::to_string(kMaxCases) +
                         " are allowed");
      points = 1;  // enough to see what else is wrong with the base
    }
    std::map<std::string, std::size_t> numbers;  // of the cases, by their ids
    for (std::size_t point = 0; static_cast<double>(point) < points; ++point) {
      const auto made = read_case(base, study.axes, axis_indices(study.axes, point));
      if (!made) continue;
      const auto [number, is_new] = numbers.emplace(case_id(*made), study.cases.size());
      if (is_new) study.cases.push_back(*made);
      study.points.push_back(number->second);
    }
    if (is_too_large) return;
    for (const Issue& issue : dropped_.faults()) fault(issue.pointer, issue.message);
    study.notes = notes_on(study, dropped_, choices_, warnings_);
  }

  std::optional<Case> read_case(json& base, const std::vector<Axis>& axes, const AxisIndices& indices) {
    json flat = base;
    std::set<std::string> left_out = faulty_axes_;
    std::set<std::string> known_to_be_faulty = faulty_axes_;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const std::string parameter = axes[axis].parameter();
      const json value = axes[axis].value(indices[axis]);
      const bool is_faulty = faulty_values_.contains({axis, indices[axis]});
      if (is_faulty) known_to_be_faulty.insert(parameter);
      if (is_faulty && is_large(value))
        left_out.insert(parameter);
      else
        flat[parameter] = value;
    }
    const ParsedCase parsed = left_out.empty() ? read_with_effect(flat, axes, indices) : parse_case(flat);
    for (const Issue& issue : parsed.issues)
      if (!known_to_be_faulty.contains(first_token(issue.pointer)) && !issue.without_effect)
        add_case_fault(issue, base, axes, indices);
    for (const Choice& choice : parsed.choices) ++choices_[in_words(choice)];
    if (parsed.value)
      for (const std::string& warning : case_warnings(*parsed.value)) ++warnings_["warning: " + warning];
    return parsed.value;
  }

  /// Drops the keys that have no effect at this point. Where a faulty value is left out nobody knows which
  /// have.
  ParsedCase read_with_effect(json& flat, const std::vector<Axis>& axes, const AxisIndices& indices) {
    dropped_.count_point(listed_values(axes, indices));
    const auto is_useless = [](const Issue& issue) { return issue.without_effect; };
    ParsedCase parsed = parse_case(flat);
    for (; std::any_of(parsed.issues.begin(), parsed.issues.end(), is_useless); parsed = parse_case(flat))
      for (const Issue& issue : parsed.issues)
        if (is_useless(issue)) {
          dropped_.add(issue, study_pointer(issue.pointer, axes, indices), axis_value(issue, axes, indices));
          erase_at(flat, issue.pointer);
        }
    return parsed;
  }

  /// The values of the axes that are lists; those of a range have one pointer together.
  static std::vector<DroppedKeys::AxisValue> listed_values(const std::vector<Axis>& axes,
                                                           const AxisIndices& indices) {
    std::vector<DroppedKeys::AxisValue> values;
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
      if (axes[axis].is_list()) values.emplace_back(axis, indices[axis]);
    return values;
  }

  /// The value of such an axis that the issue concerns.
  static std::optional<DroppedKeys::AxisValue> axis_value(const Issue& issue, const std::vector<Axis>& axes,
                                                          const AxisIndices& indices) {
    const auto axis = axis_of(issue.pointer, axes);
    if (!axis || !axes[*axis].is_list()) return std::nullopt;
    return DroppedKeys::AxisValue{*axis, indices[*axis]};
  }

  void add_case_fault(const Issue& issue, json& base, const std::vector<Axis>& axes,
                      const AxisIndices& indices) {
    fault(study_pointer(issue.pointer, axes, indices), issue.message);
    if (const auto axis = axis_of(issue.pointer, axes))
      faulty_values_.insert({*axis, indices[*axis]});
    else
      erase_at(base, issue.pointer);
  }

  const json& document_;
  Issues& issues_;
  std::set<std::string> faulty_;       ///< pointers
  std::set<std::string> faulty_axes_;  ///< parameters: that the cases lack them is no second fault
  std::set<std::pair<std::size_t, std::size_t>> faulty_values_;  ///< axis, index of the value
  DroppedKeys dropped_;
  CountedSentences choices_;   ///< what the solver chose
  CountedSentences warnings_;  ///< of settings that make the answer doubtful
};

}  // namespace

json Study::asked_at(std::size_t point) const {
  json asked = document["base"];
  const AxisIndices indices = axis_indices(axes, point);
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    asked[axes[axis].parameter()] = axes[axis].value(indices[axis]);
  for (const char* key : {"until", "outputs"}) asked.erase(key);
  return asked;
}

ParsedStudy parse_study(const json& document) {
  ParsedStudy parsed;
  if (!document.is_object()) {
    parsed.issues.push_back({"", std::string("a study must be an object, is ") + document.type_name()});
    return parsed;
  }
  json alike = document;
  spell_numbers_alike(alike);
  parsed.issues = rename_mistyped_keys_of_study(alike);
  Study study = StudyReader(alike, parsed.issues).read();
  if (parsed.issues.empty()) parsed.value = std::move(study);
  limit_number(parsed.issues);
  return parsed;
}

ParsedStudy parse_study_text(std::string_view text) {
  ParsedJson json = parse_json(text);
  limit_number(json.issues);
  if (!json.value) return {std::nullopt, std::move(json.issues)};
  return parse_study(*json.value);
}

}  // namespace capstan
