#pragma once
// The computed points of one row: all parameters but one are fixed. The search for the boundary between
// tumbling and tank-treading (next_values.hpp) reads nothing else.
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "solver/run_directory/result_words.hpp"

namespace capstan {

/// What a search is asked for.
struct BoundarySearch {
  double from = 0, to = 0;  ///< searched range of the parameter, 0 < from < to
  double tolerance = 0.01;  ///< relative to the value of the parameter
};

struct RowPoint {
  double value = 0;  ///< of the searched parameter
  bool has_ended = false;
  std::optional<Motion> motion;  ///< nothing without a label: not ended, failed or undecided
  bool is_confirmed = false;     ///< a coarser resolution has the same label, and the error cannot change it
  double r = 0;                  ///< share of the shape in the half-turns
  double D_min = 0;              ///< smallest distance of Q to 0
  double error = std::numeric_limits<double>::quiet_NaN();  ///< of Q; NaN if unknown
};

/// Signed smallest distance of Q to 0: positive if the shape turns over in all half-turns, negative if it
/// fails to do so. At the boundary Q passes through 0, and the distance changes its sign smoothly.
inline double score(const RowPoint& point) { return point.r >= kOfShape ? point.D_min : -point.D_min; }

inline bool has_class(const RowPoint& point) {
  return point.is_confirmed && (point.motion == Motion::tumbling || point.motion == Motion::tank_treading);
}

/// The points that have a label, ascending.
inline std::vector<RowPoint> labelled(std::vector<RowPoint> row) {
  std::erase_if(row, [](const RowPoint& point) { return !point.motion; });
  std::ranges::sort(row, {}, &RowPoint::value);
  return row;
}

}  // namespace capstan
