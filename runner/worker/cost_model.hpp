#pragma once
// Estimates how long a study takes on this machine, from short runs of some of its cases.
#include <functional>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// Measures a case for `seconds` of wall time. Returns how many seconds of one core it takes to its end.
using CaseTimer = std::function<double(const Case& c, double seconds)>;

/// Runs the case and extrapolates from its steps so far.
double time_by_short_run(const Case& c, double seconds);

/// Seconds of one core that each case takes to its end.
///
/// Cases of one kind have the same flow model and fidelity. Some of each kind, spread evenly over the list,
/// are measured, for two seconds in all. Any other case takes run_cost() times the ratio measured/run_cost()
/// of the nearest measured case of its kind; the distance is that of (log Ca, log V). A run that ends early
/// because its class is certain takes less.
std::vector<double> estimated_seconds(const std::vector<Case>& cases,
                                      const CaseTimer& time = time_by_short_run);

/// Expected wall time of cases that take `seconds` of one core each and run side by side on `cores` cores.
/// When the queue is empty, cores wait for the last cases: on average for half of the longest one.
double wall_seconds(const std::vector<double>& seconds, int cores);

}  // namespace capstan
