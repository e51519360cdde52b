#pragma once
// How large a capsule is at rest, and how many cells the grids around it have: what cost, memory and disk
// space of a run are estimated from.
#include "solver/case/case.hpp"

namespace capstan {

/// Semi-axes of a spheroid at rest / a; it has the volume of the unit sphere. 1 and 1 for other shapes.
struct SemiAxes {
  double along_axis = 1, across = 1;
};
SemiAxes semi_axes(const Case& c);

/// Cells of a grid over the whole domain.
double uniform_cells(const Case& c);

/// Cells of the finest grid of the composite that are solved for: the box around the capsule, which is
/// inclined by pi/4, and its margins; a quarter of them where the symmetry is made use of.
double composite_cells(const Case& c);

}  // namespace capstan
