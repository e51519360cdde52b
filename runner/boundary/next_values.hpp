#pragma once
// The search for the boundary between tumbling and tank-treading along one parameter.
//
// The first points of a row explore it: evenly spaced in the logarithm of the parameter. Wherever the motion
// changes between two of them, further points follow until the change is located. They are found by root
// finding on the score, the signed distance of Q to 0, with a bracket around the root at all times.
//
// Three changes are sought: that of the sign of the score, at which Q passes through 0 (the boundary itself),
// and the two ends of the band in which the motion is a transition. The boundary is located to the tolerance,
// the ends of the band to a quarter of its width.
//
// The next values are a function of the recorded points of the row alone, and there are none while a point of
// the row has not ended. So all points of a study are the same whatever the order in which cases end, however
// many run at a time, and however often the daemon is killed.
#include <vector>

#include "runner/boundary/row.hpp"

namespace capstan {

/// The values at which the row is to be computed next, the most useful first. None if a point has not ended,
/// or if all changes are located.
std::vector<double> next_values(const BoundarySearch& search, const std::vector<RowPoint>& row);

/// How many more points the row will probably ask for: a guess for those who wait.
int expected_values(const BoundarySearch& search, const std::vector<RowPoint>& row);

}  // namespace capstan
