#include "runner/worker/timed_run.hpp"

#include <chrono>
#include <ctime>

#include "solver/case/parse.hpp"

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

/// Keeps the history, and asks for the end when the time is up.
class Stopwatch : public RunOutput {
 public:
  explicit Stopwatch(double longest) : longest_(longest) {}

  void record(const Record& now) override { history.push_back(now); }
  void shape(double, int, const Points&, const Points&, const Points&) override {}
  void checkpoint(StateArchive) override {}
  bool is_checkpoint_due(long) override { return false; }
  bool interrupted() const override {
    if (++steps_ == 1) first_step_ = seconds_since(start_);
    return steps_ > 1 && seconds_since(start_) > longest_;
  }

  double since_first_step() const { return seconds_since(start_) - first_step_; }

  History history;

 private:
  double longest_;
  Clock::time_point start_ = Clock::now();
  mutable long steps_ = 0;
  mutable double first_step_ = 0;
};

}  // namespace

TimedRun timed_run(const Case& c, double longest_seconds) {
  Simulation simulation(c);
  const double cpu = processor_seconds();
  const auto start = Clock::now();
  Stopwatch stopwatch(longest_seconds);
  const Outcome outcome = simulation.run(stopwatch);
  return {.outcome = outcome,
          .history = std::move(stopwatch.history),
          .verdict = simulation.verdict(),
          .steps = simulation.statistics().steps,
          .kt = simulation.kt(),
          .seconds = processor_seconds() - cpu,
          .wall_seconds = seconds_since(start),
          .steady_seconds = stopwatch.since_first_step()};
}

Case red_cell(double Ca, double dx, int nodes, double kdt, double kt) {
  return parse_case({{"shape", "biconcave"},
                     {"law", "skalak"},
                     {"C", 5},
                     {"E_b", 0.015},
                     {"Ca", Ca},
                     {"V", 4},
                     {"fluid", "quasisteady"},
                     {"until", {{"kt", kt}}},
                     {"fidelity", {{"preset", "standard"}, {"dx", dx}, {"nodes", nodes}, {"kdt", kdt}}}})
      .value.value();
}

}  // namespace capstan
