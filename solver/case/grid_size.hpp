#pragma once
// Size of the capsule at rest and number of grid cells: cost, memory and disk space of a run are estimated
// from them.
#include <string>

#include "solver/case/case.hpp"

namespace capstan {

/// Edge of the domain where the case file gives none: 25.6 on a composite grid, else 12.8 as in the paper.
/// Compared with 12.8 the wider domain takes a tenth more time, and its walls change Q by a sixth to a tenth
/// as much (studies/cross_validation).
double usual_box(const Case& c);

/// Semi-axes / a of a spheroid with the volume of the unit sphere; 1 and 1 for other shapes.
struct SemiAxes {
  double along_axis = 1, across = 1;
};
SemiAxes semi_axes(const Case& c);

/// Why the grid cannot be coarsened as its multigrid method requires; "" if it can.
std::string issue_of_grid(const Case& c);

/// Number of cells of a uniform grid over the whole domain.
double uniform_cells(const Case& c);

/// Number of cells of the finest level of the composite grid on which the flow is solved: the box around the
/// capsule, which is inclined by pi/4, with margins; a quarter of them if the symmetry is used.
double composite_cells(const Case& c);

}  // namespace capstan
