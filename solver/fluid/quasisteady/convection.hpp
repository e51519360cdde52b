#pragma once
// How the flow carries its own momentum: Re (u . grad) u, of the deviation from the undisturbed flow with
// itself. What the undisturbed flow has to do with grows with the distance from its centre and is part of
// every sweep (sweep.hpp). This rest is of the order Re times the deviation, small everywhere, and kept over
// a solve like a force.
#include "solver/grid/row_field.hpp"

namespace capstan {

/// defect of momentum -= inertia (g . grad) g in a field of moments, by central differences; ghosts are used.
/// \param inertia Re nu dx / a
template <class T>
void subtract_convection(const RowField<T>& moments, double inertia, RowField<T>& defect);

}  // namespace capstan
