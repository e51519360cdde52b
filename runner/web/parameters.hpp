#pragma once
// What each route takes in its query and in its body; everything else is refused, with what is allowed.
#include <span>
#include <string>
#include <string_view>

#include "runner/web/message.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

struct Parameter {
  std::string_view name;
  std::string (*fault_of)(const std::string& value);  ///< "" for a value that makes sense
  bool may_repeat = false;
};

/// Parameters that the route does not have, that stand twice or without a value, and values that make no
/// sense.
Issues check_query(std::span<const Parameter> known, const Query& query);

/// Of a body that is an object with some of these keys, or nothing at all.
Issues check_body(std::span<const std::string_view> keys, const std::string& body);

/// Of lists in pages.
std::span<const Parameter> page_parameters();
/// Of a study's cases: also state, motion and the parameters of a case.
std::span<const Parameter> case_list_parameters();
std::span<const Parameter> phase_diagram_parameters();
std::span<const Parameter> history_parameters();

}  // namespace capstan
