#pragma once
// The query parameters that each route accepts.
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace capstan {

struct QueryParameter {
  std::string_view name;
  /// What is wrong with a value, "" if nothing.
  std::function<std::string(const std::string& value)> issue_of;
  bool may_repeat = false;
};

std::span<const QueryParameter> page_parameters();       ///< of a list in pages
std::span<const QueryParameter> case_list_parameters();  ///< of the list of a study's cases, with its filters
std::span<const QueryParameter> histories_parameters();  ///< the same filters, and the time grid
std::span<const QueryParameter> phase_diagram_parameters();
std::span<const QueryParameter> shapes_parameters();
std::span<const QueryParameter> format_parameters();

}  // namespace capstan
