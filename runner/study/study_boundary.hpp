#pragma once
// The part "boundary" of a study: instead of axes, a parameter along which the boundary between tumbling and
// tank-treading is searched.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/boundary/row.hpp"
#include "runner/study/axis.hpp"
#include "runner/study/issue_collector.hpp"

namespace capstan {

struct StudyBoundary {
  static constexpr double kTolerance = 0.01, kMinTolerance = 1e-4, kMaxTolerance = 0.2;
  static constexpr int kExplored = 8, kMinExplored = 3, kMaxExplored = 1000;

  std::string along;                 ///< the parameter that is searched
  std::vector<std::string> rows_of;  ///< the parameters of the rows, in the order of axis_parameters()
  BoundarySearch search;
  int explored = 0;  ///< first values of each row, evenly spaced in the logarithm

  /// The distance of neighbouring first values, relative to the lower one. An island of another motion that
  /// is wider contains at least one of them.
  double explored_gap() const;
};

struct BoundaryParts {
  std::optional<StudyBoundary> boundary;  ///< nothing if it is not known along what
  std::vector<Axis> axes;                 ///< their product are the first points
  std::vector<std::string> invalid_axes;  ///< parameters whose values have issues
};

/// Reads the value of /boundary.
BoundaryParts read_boundary(const nlohmann::json& given, IssueCollector& issues);

/// The keys of "boundary".
const std::vector<std::string_view>& boundary_keys();

/// The boundary of a study that was valid when it was stored; nothing if it has none.
std::optional<StudyBoundary> boundary_of(const nlohmann::json& document);

}  // namespace capstan
