#pragma once
// What makes a run impossible although each of its numbers is in range: too many steps, records or files, a
// grid that does not fit into memory, a box that the capsule does not fit into.
#include "solver/case/case.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// The least shear time kt of a run, a step of ab2, and between two records or shapes. Times are kept to
/// 1e-9.
inline constexpr double kMinTime = 1e-6;

/// All limits that a case is beyond, each with what to change. Empty for a case that can be run.
Issues limits_exceeded(const Case& c);

/// Bytes of the grid of a lattice that covers the whole domain; 0 for other models, whose grids are small.
double grid_bytes(const Case& c);

}  // namespace capstan
