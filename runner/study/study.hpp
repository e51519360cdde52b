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
inline constexpr std::size_t kMaxCases = 10000;

/// The points are the product of the axes, the last axis varying fastest. Different points can be the same
/// case: where a value that was asked for has no effect, or resolves to what stands at another point.
struct Study {
  std::string name;
  std::string description;
  std::vector<Axis> axes;           ///< in the order of axis_parameters()
  std::vector<Case> cases;          ///< each once, in the order of the points
  std::vector<std::size_t> points;  ///< which case each point is
  std::vector<std::string> notes;   ///< what was done with the study that its author may not expect
  nlohmann::json document;          ///< as it was given, in one spelling: no -0.0, and 4 for 4.0

  /// The scalar parameters and the fidelity as asked for at a point, by the base or an axis.
  nlohmann::json asked_at(std::size_t point) const;
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
