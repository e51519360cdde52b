#pragma once
// How the membrane moves in time where a case file leaves it open: after the stiffness of the membrane.
#include "solver/case/case.hpp"

namespace capstan {

/// Rate (in k) at which the membrane's fastest mode decays: the stiffness that a time step has to follow. An
/// estimate for the shape at rest, see the comment in time_step_defaults.cpp.
double fastest_decay(const Case& c);

/// The time step of ab2: short enough to be accurate and, where the shape does not change much, stable.
double default_kdt(const Case& c);

/// ab2 on a lattice, as long as its accurate steps are stable; rkc2, which measures the stiffness, for all
/// others.
Stepper default_stepper(const Case& c);

}  // namespace capstan
