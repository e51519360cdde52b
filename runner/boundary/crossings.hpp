#pragma once
// Where the motion changes along a row.
#include <optional>
#include <vector>

#include "runner/boundary/row.hpp"

namespace capstan {

/// Two points between which something changes, as indices into the labelled points of a row.
struct Bracket {
  std::size_t low = 0, high = 0;
  bool operator==(const Bracket&) const = default;
};

/// A part of a row in which the motion changes: between two neighbouring points that have a class (a
/// confirmed motion), or between such a point and an end of the row. Points without a class lie inside. They
/// say where to look, and are never relied upon.
struct Crossing {
  std::size_t first = 0, last = 0;  ///< the points at its ends
  Motion from = Motion::undecided;  ///< of the first point
  Motion to = Motion::undecided;    ///< of the last point
  Bracket begin;                    ///< the first change of label
  Bracket end;                      ///< the last change of label
  /// Where Q passes through 0, if it does: from the first change of sign of the score to the last one.
  std::optional<Bracket> passage;
};

/// \param points  the labelled points of a row
std::vector<Crossing> find_crossings(const std::vector<RowPoint>& points);

}  // namespace capstan
