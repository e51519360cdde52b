#pragma once
// Convection of momentum, Re (u . grad) u, where u is the deviation from the undisturbed flow. The terms that
// contain the undisturbed flow grow with the distance from its centre, and are part of every sweep
// (moment_sweep.hpp). The term here is quadratic in the deviation, small everywhere, and kept constant during
// a solve like a force.
#include "solver/grid/row_field.hpp"

namespace capstan {

/// Subtracts inertia (g . grad) g, by central differences, from the momentum components of `defect`.
/// \param moments  their momentum is g; ghosts are used
/// \param inertia  Re nu dx / a
template <class T>
void subtract_convection(const RowField<T>& moments, double inertia, RowField<T>& defect);

}  // namespace capstan
