#pragma once
// The boundary at one row: its value, and the limits between which it lies.
#include <optional>
#include <vector>

#include "runner/boundary/crossings.hpp"

namespace capstan {

struct Location {
  /// Where Q passes through 0, interpolated; nothing if it does not within the row.
  std::optional<double> value;
  std::optional<double> below, above;  ///< the computed points next to it
  /// The boundary lies between these if the errors of the cases are as estimated. Nothing: not bounded there.
  std::optional<double> low, high;
  /// Between these the motion is a transition: last point of one motion, first point of the other. Nothing:
  /// beyond the row.
  std::optional<double> band_begin, band_end;
  /// The nearest points that have a class.
  std::optional<double> confirmed_below, confirmed_above;
};

/// \param points  the labelled points of a row, of which find_crossings has found the crossing
Location locate(const std::vector<RowPoint>& points, const Crossing& crossing);

}  // namespace capstan
