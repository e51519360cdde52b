#pragma once
// A run in memory, without files, and the time it took.
#include "solver/case/case.hpp"
#include "solver/observe/classify.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

struct TimedRun {
  Outcome outcome;  ///< interrupted if the limit of time was reached
  History history;
  Verdict verdict;
  long steps = 0;           ///< steps of the membrane
  double kt = 0;            ///< end of the last step
  double cpu_seconds = 0;   ///< processor time of all threads
  double wall_seconds = 0;  ///< of all steps
  /// Wall time of all steps but the first, whose flow has no previous one to start from.
  double steady_seconds = 0;

  /// Wall time of a step after the first.
  double seconds_per_step() const;
};

/// Runs a case until it ends or has taken `max_seconds` of wall time, but at least two steps.
TimedRun timed_run(const Case& c, double max_seconds = 1e9);

/// Runs a case to its end. Throws std::runtime_error with the reason if it breaks down: the time of a run
/// without an answer is no time.
TimedRun complete_run(const Case& c);

}  // namespace capstan
