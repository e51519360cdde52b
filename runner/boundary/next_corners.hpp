#pragma once
// A grid over two parameters that is made finer where the motion changes.
//
// A cell whose corners have different labels is divided, in halves along each side that is too long, until
// the sides are short enough. A cell is divided once all of its corners have ended, by their labels alone: so
// the points are the same whatever the order in which cases end. A corner without a label (failed, undecided)
// is passed over; a label that is not confirmed says where to look.
#include <array>
#include <map>
#include <vector>

#include "runner/boundary/row.hpp"

namespace capstan {

using Corner = std::array<double, 2>;  ///< values of the two parameters

/// The computed points of a grid and of the cells that were divided.
struct RefinedGrid {
  std::array<std::vector<double>, 2> values;  ///< of the first grid, ascending
  std::array<double, 2> sides{};              ///< a cell whose sides are at most these is not divided
  std::map<Corner, RowPoint> points;          ///< all that were asked for
};

/// The points at which the grid is to be computed next, each once.
std::vector<Corner> next_corners(const RefinedGrid& grid);

}  // namespace capstan
