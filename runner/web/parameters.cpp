#include "runner/web/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "runner/queries/queries.hpp"
#include "runner/queries/typed_value.hpp"
#include "runner/study/axis.hpp"

namespace capstan {
namespace {

std::string anything(const std::string&) { return ""; }

std::string fault_of_limit(const std::string& value) {
  const auto limit = number_in<int>(value);
  if (limit && *limit >= 1 && *limit <= PageRequest::kMax) return "";
  return "must be a whole number from 1 to " + std::to_string(PageRequest::kMax);
}

std::string fault_of_number(const std::string& value) {
  const auto number = number_in<double>(value);
  return number && std::isfinite(*number) ? "" : "must be a number";
}

std::string listed(std::span<const std::string_view> words) {
  std::string list;
  for (const std::string_view each : words) list += (list.empty() ? "" : ", ") + std::string(each);
  return list;
}

std::string fault_of_word(const std::string& value, std::span<const std::string_view> words) {
  if (std::find(words.begin(), words.end(), value) != words.end()) return "";
  return "must be one of: " + listed(words);
}

/// For a parameter whose values are these words.
template <class... Words>
std::string fault_among(const std::string& value, Words... words) {
  const std::string_view all[] = {words...};
  return fault_of_word(value, all);
}

std::string fault_of_state(const std::string& value) {
  return fault_among(value, "queued", "running", "done", "failed", "diverged", "cancelled");
}

std::string fault_of_motion(const std::string& value) {
  return fault_among(value, "tumbling", "tank_treading", "transition", "undecided");
}

std::string fault_of_shape(const std::string& value) {
  return fault_among(value, to_string(Shape::sphere), to_string(Shape::oblate), to_string(Shape::prolate),
                     to_string(Shape::biconcave));
}

std::string fault_of_law(const std::string& value) {
  return fault_among(value, to_string(Law::neo_hookean), to_string(Law::skalak));
}

std::string fault_of_bending(const std::string& value) {
  return fault_among(value, to_string(BendingModel::variational), to_string(BendingModel::helfrich_literal));
}

std::string fault_of_fluid(const std::string& value) {
  return fault_among(value, to_string(Fluid::quasisteady), to_string(Fluid::transient),
                     to_string(Fluid::stokes), "auto");
}

std::string fault_of_c0(const std::string& value) {
  if (fault_of_number(value).empty() || fault_among(value, "initial", "uniform").empty()) return "";
  return "must be a number, or one of: initial, uniform";
}

std::string fault_of_fidelity(const std::string& value) {
  if (nlohmann::json::parse(value, nullptr, false).is_object()) return "";
  const std::string fault = fault_among(value, "fast", "standard", "fine", "paper");
  return fault.empty() ? "" : fault + "; or an object of knobs";
}

std::string fault_of_axis(const std::string& value) { return fault_of_word(value, axis_parameters()); }

std::string fault_of_format(const std::string& value) { return fault_among(value, "json", "csv"); }

constexpr Parameter kPage[] = {
    {"limit", fault_of_limit},
    {"after", anything},  // a cursor is checked against its list, where that is known
};

constexpr Parameter kCaseList[] = {
    {"limit", fault_of_limit},       {"after", anything},       {"state", fault_of_state},
    {"motion", fault_of_motion},     {"shape", fault_of_shape}, {"aspect", fault_of_number},
    {"law", fault_of_law},           {"C", fault_of_number},    {"Ca", fault_of_number},
    {"V", fault_of_number},          {"Re", fault_of_number},   {"E_b", fault_of_number},
    {"bending", fault_of_bending},   {"c0", fault_of_c0},       {"fluid", fault_of_fluid},
    {"fidelity", fault_of_fidelity},
};

constexpr Parameter kPhaseDiagram[] = {
    {"x", fault_of_axis},
    {"y", fault_of_axis},
    {"at", anything, true},  // AXIS=VALUE is checked against the study, where that is known
};

constexpr Parameter kHistory[] = {{"format", fault_of_format}};

std::string names_of(std::span<const Parameter> parameters) {
  std::vector<std::string_view> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  return listed(names);
}

std::string fault_of(const Parameter& parameter, const std::string& value, bool has_come) {
  if (has_come && !parameter.may_repeat) return "stands twice";
  return value.empty() ? "has no value" : parameter.fault_of(value);
}

}  // namespace

Issues check_query(std::span<const Parameter> known, const Query& query) {
  Issues issues;
  std::set<std::string> have_come;
  for (const auto& [name, value] : query) {
    const auto parameter =
        std::find_if(known.begin(), known.end(), [&](const Parameter& each) { return each.name == name; });
    const bool is_known = parameter != known.end();
    const std::string fault = is_known        ? fault_of(*parameter, value, !have_come.insert(name).second)
                              : known.empty() ? "is unknown: there are no parameters here"
                                              : "is unknown; there are: " + names_of(known);
    if (!fault.empty()) issues.push_back({name, fault});
  }
  return issues;
}

Issues check_body(std::span<const std::string_view> keys, const std::string& body) {
  if (body.find_first_not_of(" \t\r\n") == body.npos) return {};
  const ParsedJson parsed = parse_json(body);
  if (!parsed.value) return parsed.issues;
  if (!parsed.value->is_object())
    return {{"", std::string("must be an object, is ") + parsed.value->type_name()}};
  Issues issues;
  for (const auto& [key, value] : parsed.value->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      issues.push_back(
          {(nlohmann::json::json_pointer() / key).to_string(),
           keys.empty() ? "unknown key; send no body" : "unknown key; there are: " + listed(keys)});
  return issues;
}

std::span<const Parameter> page_parameters() { return kPage; }
std::span<const Parameter> case_list_parameters() { return kCaseList; }
std::span<const Parameter> phase_diagram_parameters() { return kPhaseDiagram; }
std::span<const Parameter> history_parameters() { return kHistory; }

}  // namespace capstan
