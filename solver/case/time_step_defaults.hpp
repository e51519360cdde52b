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

/// The time step of a case with the stepper that it has: default_kdt for ab2, 0 for rkc2, which chooses its
/// steps.
double kdt_of_stepper(const Case& c);

/// Gives a case the stepper and the time step that it has by default.
void choose_time_step(Case& c);

/// Flow solutions that rkc2 takes in a unit of kt. Its longest accurate step is 0.1, for soft membranes up to
/// 0.2. A step takes one flow solution a stage; stability at the fastest decay rate sets the number of
/// stages.
double rkc2_flows(const Case& c);

/// Processor time of a flow solution of rkc2 on a lattice, over that of ab2. Flows of ab2 are extrapolated
/// from equal steps and take one cycle; those of the stages of rkc2 start from the last solution and take
/// about two. Measured at dx = 0.2 to kt = 20: the stepper that follows from this factor takes less time than
/// the other one, or at most 15 % more, for 16 of 17 spheres, spheroids and red cells.
inline constexpr double kRkc2Cost = 1.6;

/// The stepper that takes less processor time. ab2 only on a lattice, and only where its accurate steps are
/// stable. The paper's scheme keeps ab2 as long as it is stable.
Stepper default_stepper(const Case& c);

}  // namespace capstan
