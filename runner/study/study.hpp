#pragma once
// A study: one base case and the axes along which it varies, expanded into validated cases.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/study/axis.hpp"
#include "runner/study/study_boundary.hpp"
#include "runner/study/study_refinement.hpp"
#include "solver/case/case.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// A study with more points is refused before it is expanded.
inline constexpr std::size_t kMaxCases = 10000;

/// The points are the product of the axes, the last axis varying fastest. Different points can be the same
/// case, e.g. where the value that differs has no effect. If the study seeks a boundary or
/// refines its grid, these are the first points, and others follow (runner/daemon/extend_search.hpp).
struct Study {
  std::string name;
  std::string description;
  std::vector<Axis> axes;                     ///< in the order of axis_parameters()
  std::optional<StudyBoundary> boundary;      ///< if it seeks one instead of a grid
  std::optional<StudyRefinement> refinement;  ///< if its grid is made finer
  std::vector<Case> cases;                    ///< each once, in the order of the points
  std::vector<std::size_t> points;            ///< for each point, the index of its case
  std::vector<std::string> notes;  ///< sentences on what the author may not expect (study_notes.hpp)
  nlohmann::json document;         ///< as it was given, in one spelling: no -0.0, and 4 for 4.0

  /// The scalar parameters and the fidelity as asked for at a point, by the base or an axis.
  nlohmann::json asked_at(std::size_t point) const;
};

struct ParsedStudy {
  std::optional<Study> value;  ///< engaged when issues is empty
  Issues issues;               ///< pointers into the study's document
};

/// Reads and expands a study. Every issue is reported once; the pointer of an issue of an expanded case is
/// that of the axis value or base key that it comes from. Of more than 100 issues the others are only
/// counted.
ParsedStudy parse_study(const nlohmann::json& document);

/// Reads a study from text that need not be JSON.
ParsedStudy parse_study_text(std::string_view text);

}  // namespace capstan
