#include "runner/web/query_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "runner/queries/queries.hpp"
#include "runner/queries/typed_value.hpp"
#include "runner/queue/case_state.hpp"
#include "runner/render/comma_separated.hpp"
#include "runner/study/axis.hpp"
#include "runner/web/listed.hpp"
#include "solver/case/parameters.hpp"
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

std::string issue_of_distance(const std::string& value) {
  const auto number = number_in<double>(value);
  return number && std::isfinite(*number) && *number > 0 ? "" : "must be a number above 0";
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

std::string issue_of_state(const std::string& value) { return issue_of_word(value, words_of<CaseState>()); }

std::string issue_of_motion(const std::string& value) { return issue_of_word(value, words_of<Motion>()); }

/// What is wrong with the text as a value of a parameter of a case; "" if nothing.
std::string issue_of_parameter(const Parameter& parameter, const std::string& value) {
  const std::vector<std::string> texts = parameter.value->words();
  const std::vector<std::string_view> words(texts.begin(), texts.end());
  const bool takes_numbers = parameter.value->takes_numbers();
  if (takes_numbers && (words.empty() || issue_of_number(value).empty())) return issue_of_number(value);
  const std::string issue = issue_of_word(value, words);
  return issue.empty() || !takes_numbers ? issue : "must be a number, or one of: " + listed(words);
}

std::string issue_of_fidelity(const std::string& value) {
  if (nlohmann::json::parse(value, nullptr, false).is_object()) return "";
  const std::string issue = issue_of_word(value, preset_names());
  return issue.empty() ? "" : issue + "; or an object of knobs";
}

std::string issue_of_axis(const std::string& value) { return issue_of_word(value, axis_parameters()); }

/// The names of observables, separated by commas.
std::string issue_of_columns(const std::string& value) {
  const std::vector<std::string> columns = columns_on_grid();
  const std::vector<std::string_view> known(columns.begin(), columns.end());
  for (const std::string& name : comma_separated(value))
    if (const std::string issue = issue_of_word(name, known); !issue.empty()) return "each " + issue;
  return "";
}

std::string issue_of_format(const std::string& value) { return issue_unless_among(value, "json", "csv"); }

std::string issue_of_shape_format(const std::string& value) {
  return issue_unless_among(value, "json", "binary", "vtp", "stl", "obj");
}

std::string issue_of_index(const std::string& value) {
  return number_in<std::size_t>(value) ? "" : "must be a whole number from 0 on";
}

std::vector<QueryParameter> filters_of_cases() {
  std::vector<QueryParameter> filters = {{"limit", issue_of_limit},
                                         {"after", no_issue},  // read_page_query() checks it against its list
                                         {"format", issue_of_format},
                                         {"state", issue_of_state},
                                         {"motion", issue_of_motion}};
  for (const Parameter& parameter : parameters())
    if (parameter.group.empty())
      filters.push_back({parameter.key, [&parameter](const std::string& value) {
                           return issue_of_parameter(parameter, value);
                         }});
  filters.push_back({"fidelity", issue_of_fidelity});
  return filters;
}

}  // namespace

std::span<const QueryParameter> page_parameters() {
  static const std::vector<QueryParameter> page = {{"limit", issue_of_limit}, {"after", no_issue}};
  return page;
}

std::span<const QueryParameter> case_list_parameters() {
  static const std::vector<QueryParameter> filters = filters_of_cases();
  return filters;
}

std::span<const QueryParameter> histories_parameters() {
  static const std::vector<QueryParameter> histories = [] {
    std::vector<QueryParameter> all = filters_of_cases();
    all.push_back({"every", issue_of_distance});
    all.push_back({"columns", issue_of_columns});
    return all;
  }();
  return histories;
}

std::span<const QueryParameter> phase_diagram_parameters() {
  static const std::vector<QueryParameter> diagram = {
      {"x", issue_of_axis},
      {"y", issue_of_axis},
      {"format", issue_of_format},
      {"at", no_issue, true}};  // AXIS=VALUE: phase_diagram() checks it against the study
  return diagram;
}

std::span<const QueryParameter> format_parameters() {
  static const std::vector<QueryParameter> format = {{"format", issue_of_format}};
  return format;
}

std::span<const QueryParameter> shapes_parameters() {
  static const std::vector<QueryParameter> shapes = {
      {"format", issue_of_shape_format}, {"kt", issue_of_number}, {"first", issue_of_index}};
  return shapes;
}

}  // namespace capstan
