#pragma once
// Runs without files, and what they cost.
#include "solver/case/case.hpp"
#include "solver/observe/classify.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

struct TimedRun {
  Outcome outcome;  ///< interrupted where the time was up
  History history;
  Verdict verdict;
  long steps = 0;      ///< of the membrane
  double kt = 0;       ///< where the last of them ended
  double seconds = 0;  ///< of processor time, all threads
  double wall_seconds = 0;
  double steady_seconds = 0;  ///< of wall time of all steps but the first, which starts from nothing
};

/// Runs a case to its end, or for so many seconds and at least two steps.
TimedRun timed_run(const Case& c, double longest_seconds = 1e9);

/// The paper's red cell (Skalak C = 5, E_b = 0.015, V = 4) on a lattice of this spacing, unbroken to kt.
Case red_cell(double Ca, double dx, int nodes, double kdt, double kt);

}  // namespace capstan
