#pragma once
// Estimated computing time of a run, from its case alone. It allows cases to be compared without running
// them.
#include "solver/case/case.hpp"

namespace capstan {

/// Seconds on one core of the machine on which the constants were measured. A run that ends early, because
/// its motion is certain, takes less. Clamped to 1e-4 ... 1e10.
double run_cost(const Case& c);

/// The same for all runs that a case usually takes: its own and those at coarser rungs of the ladder
/// (ladder.hpp).
double case_cost(const Case& c);

}  // namespace capstan
