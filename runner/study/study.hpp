#pragma once
// A study: one base case and the axes along which it varies, expanded into validated cases.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/study/axis.hpp"
#include "solver/case/case.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// A larger grid is refused before it is expanded.
inline constexpr std::size_t kMostCases = 10000;

struct Study {
  std::string name;
  std::string description;
  std::vector<Axis> axes;   ///< in the order of axis_parameters()
  std::vector<Case> cases;  ///< the last axis varies fastest; equal cases stand once
  nlohmann::json document;  ///< as it was given
};

struct ParsedStudy {
  std::optional<Study> value;  ///< engaged when issues is empty
  Issues issues;               ///< pointers into the study's document
};

/// Reads and expands a study. Every fault is reported, once: one of an expanded case stands at the axis value
/// or base key that it comes from. Beyond 100 faults only their number is told.
ParsedStudy parse_study(const nlohmann::json& document);

/// The same from text, which may not even be JSON.
ParsedStudy parse_study_text(std::string_view text);

}  // namespace capstan
