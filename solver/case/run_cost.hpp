#pragma once
// What a run costs, from its case alone: to weigh cases against each other without running them.
#include "solver/case/case.hpp"

namespace capstan {

/// Seconds of one core of the machine on which the constants were measured; on another in about the same
/// proportions. To the end: a run whose class is certain early is cheaper. From 1e-4 to 1e10, whatever the
/// case.
double run_cost(const Case& c);

}  // namespace capstan
