#include "runner/worker/rung_run.hpp"

#include <unistd.h>

#include <cmath>
#include <iostream>

#include "runner/worker/interruption.hpp"
#include "runner/worker/run_progress.hpp"
#include "solver/case/content_id.hpp"
#include "solver/case/equal_steps.hpp"
#include "solver/output/run_recorder.hpp"
#include "solver/run_directory/attempt_token.hpp"
#include "solver/run_directory/checkpoint_files.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

/// Writes the run directory, and prints the progress.
class ReportingRecorder : public RunRecorder {
 public:
  ReportingRecorder(const fs::path& out, const Case& c, const Choices& choices, double end_seconds)
      : RunRecorder(out, c, choices,
                    [=] { return is_interruption_wanted() || steady_seconds() > end_seconds; }),
        progress_(c.until) {}

  void record(const Record& record) override {
    check_attempt();
    RunRecorder::record(record);
    progress_.show(record);
  }

 private:
  /// Ends a run that another attempt has replaced, within a second rather than at its next checkpoint.
  void check_attempt() {
    if (steady_seconds() < next_check_) return;
    next_check_ = steady_seconds() + 1;
    expect_own_attempt();
  }

  RunProgress progress_;
  double next_check_ = 0;
};

void print_outcome(const Outcome& outcome, const Verdict& verdict) {
  const bool on_terminal =
      isatty(STDERR_FILENO);  // then the line that shows the progress still lacks its line end
  std::cerr << (on_terminal ? "\n" : "") << to_string(outcome.stop)
            << (outcome.message.empty() ? "" : ": " + outcome.message) << "\n";
  if (has_answer(outcome.stop)) std::cerr << to_string(verdict.motion) << ": " << verdict.explanation << "\n";
}

/// Makes the history of the case a link to that of the rung.
void show_history_of(const RunDirectory& rung, const RunDirectory& of_case) {
  PendingFile link(of_case.history_file());
  fs::remove(link.temporary());
  fs::create_symlink(rung.history_file().lexically_relative(of_case.path()), link.temporary());
  link.replace();
}

}  // namespace

std::optional<FinishedRun> compute_run(const Case& c, const Choices& choices, const RunDirectory& directory,
                                       double end_seconds) {
  ReportingRecorder recorder(directory.path(), c, choices, end_seconds);
  Simulation simulation(c);
  recorder.resume(simulation, [](const std::string& line) { std::cerr << line << "\n"; });
  const Outcome outcome = simulation.run(recorder);
  print_outcome(outcome, simulation.verdict());
  nlohmann::ordered_json result = recorder.finish(simulation, outcome);
  if (outcome.stop == Stop::interrupted) return std::nullopt;
  return FinishedRun{c, simulation.history(), std::move(result)};
}

std::optional<FinishedRun> compute_rung(const Case& rung, const RunDirectory& of_case, double end_seconds) {
  const RunDirectory directory = of_case.rung(rung.fidelity.nodes);
  if (auto finished = finished_run(directory, rung)) return finished;
  directory.prepare(to_json(rung).dump(2));
  show_history_of(directory, of_case);
  auto run = compute_run(rung, {}, directory, end_seconds);
  if (!run) return std::nullopt;
  write_durably(directory.result_file(), run->result.dump(2) + "\n");
  keep_newest_checkpoint(directory, steps_id(rung), kNumericsVersion);
  return run;
}

void add_seconds(nlohmann::ordered_json& result, const nlohmann::ordered_json& other) {
  nlohmann::ordered_json& seconds = result["cost"]["seconds"];
  seconds = std::round(1000 * (seconds.get<double>() + other["cost"]["seconds"].get<double>())) / 1000;
}

RunEnding write_result(const RunDirectory& directory, const FinishedRun& run) {
  write_durably(directory.result_file(), run.result.dump(2) + "\n");
  return run.is_answered() ? RunEnding::done : RunEnding::diverged;
}

}  // namespace capstan
