#pragma once
// The time derivative of the flow, Re du/dt, by backward differences (BDF2) with variable steps:
//
//   du/dt = alpha_0 u(t) + alpha_1 u(t - h) + alpha_2 u(t - h - h'),   r = h/h',
//   alpha_0 = (1 + 2 r)/(1 + r)/h,   alpha_1 = -(1 + r)/h,   alpha_2 = r^2/(1 + r)/h.
//
// It is exact for parabolas, hence of second order. It damps every decaying flow at any step, and stays
// stable while a step is at most 1 + sqrt(2) times as long as the last one (Grigorieff 1983).
//
// In the equation in moments (moment_sweep.hpp) it is a force -Re nu dx^2 du/dt (lengths in units of a). Its
// first term contains the unknown u = g - F/2 and is part of every sweep; the others are known before the
// solve and are part of D.
#include <span>

#include "solver/grid/row_field.hpp"

namespace capstan {

/// The weights of a backward difference.
struct BackwardDifference {
  double now;     ///< alpha_0, of the unknown flow
  double last;    ///< alpha_1, of the flow one step earlier
  double before;  ///< alpha_2, of the flow two steps earlier
};

/// The derivative at the time t from the flows at t and at one or two earlier times. From one it is of first
/// order: alpha_0 = -alpha_1 = 1/h.
/// \param earlier  one or two times in increasing order, before t
BackwardDifference backward_difference(std::span<const double> earlier, double t);

/// Subtracts inertia (alpha_1 last + alpha_2 before) from the momentum components of `defect`.
/// \param last, before  fields of moments, one and two steps earlier
/// \param inertia       Re nu dx^2
template <class T>
void subtract_known_part(const BackwardDifference& difference, const RowField<T>& last,
                         const RowField<T>& before, double inertia, RowField<T>& defect);

}  // namespace capstan
