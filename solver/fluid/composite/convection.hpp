#pragma once
// Momentum that is carried with the flow: small where the quasi-steady method holds, so it is taken from the
// flow as it stood when a solve began, and enters as a force.
#include "solver/fluid/composite/row_field.hpp"

namespace capstan {

/// out = defect - inertia (u . grad) u, differences over one cell on either side; `out` may be `defect`.
/// \param moments   deviation from the shear flow (y, 0, 0), ghosts filled
/// \param dx        spacing / a
/// \param inertia   Re nu dx / a, nu = 1/6: the velocity of a k in lattice units
template <class T>
void subtract_convection(const RowField<T>& moments, double dx, double inertia, const RowField<T>& defect,
                         RowField<T>& out);

}  // namespace capstan
