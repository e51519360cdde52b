#pragma once
// Stepper and time step of the membrane where the case file does not give them, from the stiffness of the
// membrane.
#include "solver/case/case.hpp"

namespace capstan {

/// Decay rate of the membrane's fastest mode, in units of k: explicit time steps are limited by its inverse.
/// An estimate for the shape at rest; time_step_defaults.cpp derives it.
double fastest_decay(const Case& c);

/// Time step of ab2 that is accurate and, as long as the shape does not change much, stable.
double default_kdt(const Case& c);

/// ab2 on a lattice if its accurate steps are stable; else rkc2, whose number of stages follows from the
/// stiffness.
Stepper default_stepper(const Case& c);

}  // namespace capstan
