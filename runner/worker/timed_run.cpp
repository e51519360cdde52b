#include "runner/worker/timed_run.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <stdexcept>

namespace capstan {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Keeps the history, and interrupts the run when the time is over.
class TimedOutput : public RunOutput {
 public:
  explicit TimedOutput(double max_seconds) : max_seconds_(max_seconds) {}

  void record(const Record& now) override { history.push_back(now); }
  void shape(double, int, const Points&, const Points&, const Points&) override {}
  void checkpoint(StateArchive) override {}
  void last_state(StateArchive) override {}
  bool is_checkpoint_due(long) override { return false; }
  /// Called by the simulation after each step.
  bool interrupted() const override {
    if (++steps_ == 1) first_step_end_ = seconds_since(start_);
    return steps_ > 1 && seconds_since(start_) > max_seconds_;
  }

  double seconds_since_first_step() const { return seconds_since(start_) - first_step_end_; }

  History history;

 private:
  double max_seconds_;
  Clock::time_point start_ = Clock::now();
  mutable long steps_ = 0;
  mutable double first_step_end_ = 0;
};

}  // namespace

double TimedRun::seconds_per_step() const { return steady_seconds / double(std::max(1L, steps - 1)); }

TimedRun timed_run(const Case& c, double max_seconds) {
  Simulation simulation(c);
  const double cpu = processor_seconds();
  const auto start = Clock::now();
  TimedOutput output(max_seconds);
  const Outcome outcome = simulation.run(output);
  return {.outcome = outcome,
          .history = std::move(output.history),
          .verdict = simulation.verdict(),
          .steps = simulation.statistics().steps,
          .kt = simulation.kt(),
          .cpu_seconds = processor_seconds() - cpu,
          .wall_seconds = seconds_since(start),
          .steady_seconds = output.seconds_since_first_step()};
}

TimedRun complete_run(const Case& c) {
  TimedRun run = timed_run(c);
  if (run.outcome.stop != Stop::reached_end)
    throw std::runtime_error("a run of the benchmark has no answer: " + run.outcome.message);
  return run;
}

}  // namespace capstan
