#include "runner/web/query_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "runner/queries/queries.hpp"
#include "runner/queries/typed_value.hpp"
#include "runner/queue/case_state.hpp"
#include "runner/study/axis.hpp"
#include "runner/web/listed.hpp"
#include "solver/run_directory/result_words.hpp"

namespace capstan {
namespace {

std::string no_issue(const std::string&) { return ""; }

std::string issue_of_limit(const std::string& value) {
  const auto limit = number_in<int>(value);
  if (limit && *limit >= 1 && *limit <= PageRequest::kMax) return "";
  return "must be a whole number from 1 to " + std::to_string(PageRequest::kMax);
}

std::string issue_of_number(const std::string& value) {
  const auto number = number_in<double>(value);
  return number && std::isfinite(*number) ? "" : "must be a number";
}

std::string issue_of_word(const std::string& value, std::span<const std::string_view> words) {
  if (std::find(words.begin(), words.end(), value) != words.end()) return "";
  return "must be one of: " + listed(words);
}

template <class... Words>
std::string issue_unless_among(const std::string& value, Words... words) {
  const std::string_view all[] = {words...};
  return issue_of_word(value, all);
}

/// \param values  the values of an enum that has to_string()
template <class Values>
std::string issue_unless_word_of(const Values& values, const std::string& value) {
  std::vector<std::string_view> words;
  for (const auto each : values) words.push_back(to_string(each));
  return issue_of_word(value, words);
}

std::string issue_of_state(const std::string& value) { return issue_unless_word_of(kCaseStates, value); }

std::string issue_of_motion(const std::string& value) { return issue_unless_word_of(kMotions, value); }

std::string issue_of_shape(const std::string& value) {
  return issue_unless_among(value, to_string(Shape::sphere), to_string(Shape::oblate),
                            to_string(Shape::prolate), to_string(Shape::biconcave));
}

std::string issue_of_law(const std::string& value) {
  return issue_unless_among(value, to_string(Law::neo_hookean), to_string(Law::skalak));
}

std::string issue_of_bending(const std::string& value) {
  return issue_unless_among(value, to_string(BendingModel::variational),
                            to_string(BendingModel::helfrich_literal));
}

std::string issue_of_fluid(const std::string& value) {
  return issue_unless_among(value, to_string(Fluid::quasisteady), to_string(Fluid::transient),
                            to_string(Fluid::stokes), "auto");
}

std::string issue_of_c0(const std::string& value) {
  if (issue_of_number(value).empty() || issue_unless_among(value, "initial", "uniform").empty()) return "";
  return "must be a number, or one of: initial, uniform";
}

std::string issue_of_fidelity(const std::string& value) {
  if (nlohmann::json::parse(value, nullptr, false).is_object()) return "";
  const std::string issue = issue_unless_among(value, "fast", "standard", "fine", "paper");
  return issue.empty() ? "" : issue + "; or an object of knobs";
}

std::string issue_of_axis(const std::string& value) { return issue_of_word(value, axis_parameters()); }

std::string issue_of_format(const std::string& value) { return issue_unless_among(value, "json", "csv"); }

constexpr QueryParameter kPage[] = {
    {"limit", issue_of_limit}, {"after", no_issue},  // read_page_query() checks the cursor against its list
};

constexpr QueryParameter kCaseList[] = {
    {"limit", issue_of_limit},       {"after", no_issue},       {"state", issue_of_state},
    {"motion", issue_of_motion},     {"shape", issue_of_shape}, {"aspect", issue_of_number},
    {"law", issue_of_law},           {"C", issue_of_number},    {"Ca", issue_of_number},
    {"V", issue_of_number},          {"Re", issue_of_number},   {"E_b", issue_of_number},
    {"bending", issue_of_bending},   {"c0", issue_of_c0},       {"fluid", issue_of_fluid},
    {"fidelity", issue_of_fidelity},
};

constexpr QueryParameter kPhaseDiagram[] = {
    {"x", issue_of_axis},
    {"y", issue_of_axis},
    {"at", no_issue, true},  // AXIS=VALUE: phase_diagram() checks it against the study
};

constexpr QueryParameter kHistory[] = {{"format", issue_of_format}};

}  // namespace

std::span<const QueryParameter> page_parameters() { return kPage; }
std::span<const QueryParameter> case_list_parameters() { return kCaseList; }
std::span<const QueryParameter> phase_diagram_parameters() { return kPhaseDiagram; }
std::span<const QueryParameter> history_parameters() { return kHistory; }

}  // namespace capstan
