#pragma once
// Limits of a run that concern several parameters together: the number of steps, records and files, the
// memory of the grid, the size of the box.
#include "solver/case/case.hpp"
#include "solver/case/issue.hpp"

namespace capstan {

/// Minimum shear time kt of a run, of a step of ab2, and between two records or shapes. Times are stored to
/// 1e-9.
inline constexpr double kMinTime = 1e-6;
inline constexpr double kMaxTime = 10000;  ///< shear time kt

/// An issue for each limit that a case exceeds, with what to change. Empty for a case that can be run.
Issues limits_exceeded(const Case& c);

/// The smallest box / a of a lattice. Half of it must contain the longest semi-axis of the capsule, as long
/// as the flow draws it out, and the cells around it to which the regularised delta function extends.
double min_box(const Case& c);

/// Memory in bytes of a lattice that covers the whole domain; 0 for models with small grids or none.
double grid_bytes(const Case& c);

}  // namespace capstan
