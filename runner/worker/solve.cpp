#include "runner/worker/solve.hpp"

#include <omp.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "runner/worker/case_file.hpp"
#include "solver/case/case_warnings.hpp"
#include "solver/case/content_id.hpp"
#include "solver/output/run_recorder.hpp"
#include "solver/run_directory/directory_lock.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/exit_code.hpp"
#include "solver/run_directory/run_ending.hpp"
#include "solver/run_directory/stop_signals.hpp"

namespace capstan {
namespace {

volatile std::sig_atomic_t interruption_wanted = 0;

/// Who starts the run with SIGHUP ignored, as nohup does, wants it to go on when the terminal is closed.
void checkpoint_on_signals() {
  for (const int signal : kStopSignals)
    if (std::signal(signal, [](int) { interruption_wanted = 1; }) == SIG_IGN && signal == SIGHUP)
      std::signal(signal, SIG_IGN);
  unblock_stop_signals();
}

/// One core a case, unless OMP_NUM_THREADS says more: a study keeps all cores busy with its cases, and
/// threads that share a core with another case wait for each other.
void use_one_core_by_default() {
  if (!std::getenv("OMP_NUM_THREADS")) omp_set_num_threads(1);
}

/// Says how far the run is: a line that overwrites itself on a terminal, a line a unit of kt elsewhere.
class Progress {
 public:
  explicit Progress(double end) : end_(end), on_terminal_(isatty(STDERR_FILENO)) {}

  void show(const Record& record) {
    if (!on_terminal_ && record.kt < next_) return;
    next_ = record.kt + 1;
    if (first_ < 0) first_ = record.kt;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    const double done = record.kt - first_;
    const double left = done > 0 ? seconds * (end_ - record.kt) / done : 0;
    std::fprintf(stderr, "%skt = %.1f of %.1f, D_xy = %.3f, about %.0f s left%s", on_terminal_ ? "\r" : "",
                 record.kt, end_, record.D_xy, left, on_terminal_ ? "   " : "\n");
  }

 private:
  double end_, first_ = -1, next_ = 0;
  bool on_terminal_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

class Worker : public RunRecorder {
 public:
  Worker(const std::filesystem::path& out, const Case& c, const Choices& choices, double end_seconds)
      : RunRecorder(out, c, choices,
                    [=] { return interruption_wanted != 0 || steady_seconds() > end_seconds; }),
        progress_(c.until.kt) {}

  void record(const Record& record) override {
    RunRecorder::record(record);
    progress_.show(record);
  }

 private:
  Progress progress_;
};

RunEnding ending_of(Stop stop) {
  if (stop == Stop::interrupted) return RunEnding::interrupted;
  return has_answer(stop) ? RunEnding::done : RunEnding::diverged;
}

/// A directory belongs to one case: the first that ran there.
bool claim_directory(const RunDirectory& directory, const Case& c) {
  const std::filesystem::path mark = directory.case_file();
  if (!std::filesystem::exists(mark)) write_durably(mark, to_json(c).dump(2) + "\n");
  const ParsedCase there = read_case(mark);
  return there.value && case_id(*there.value) == case_id(c);
}

int solve(const std::filesystem::path& case_file, const std::filesystem::path& out, double end_seconds) {
  const ParsedCase parsed = read_case(case_file);
  print_faults(case_file, parsed.issues);
  if (!parsed.value) return kExitInvalidInput;
  std::filesystem::create_directories(out);
  DirectoryLock lock = DirectoryLock::inherited_or_new(RunDirectory(out));
  if (!lock.take()) {
    std::cerr << "another process computes in " << out.string()
              << ": wait for its end, stop it, or choose another directory\n";
    return kExitError;
  }
  if (!claim_directory(RunDirectory(out), *parsed.value)) {
    std::cerr << out.string() << " holds the run of another case: choose another directory\n";
    return kExitInvalidInput;
  }
  for (const Choice& choice : parsed.choices) std::cerr << in_words(choice) << "\n";
  for (const std::string& warning : case_warnings(*parsed.value)) std::cerr << "warning: " << warning << "\n";
  Worker worker(out, *parsed.value, parsed.choices, end_seconds);
  Simulation simulation(*parsed.value);
  worker.resume(simulation, [](const std::string& line) { std::cerr << line << "\n"; });
  const Outcome outcome = simulation.run(worker);
  std::cerr << (isatty(STDERR_FILENO) ? "\n" : "") << to_string(outcome.stop)
            << (outcome.message.empty() ? "" : ": " + outcome.message) << "\n";
  if (const Verdict label = simulation.verdict(); has_answer(outcome.stop))
    std::cerr << to_string(label.motion) << ": " << label.explanation << "\n";
  worker.finish(simulation, outcome);
  return exit_code_of(ending_of(outcome.stop));
}

}  // namespace

int solve_case(const std::filesystem::path& case_file, const std::filesystem::path& out,
               double wall_seconds) {
  const double end_seconds = steady_seconds() + wall_seconds;
  checkpoint_on_signals();
  use_one_core_by_default();
  try {
    return solve(case_file, out, end_seconds);
  } catch (const std::exception& error) {
    std::cerr << "capstan solve: " << error.what() << "\n";
    return kExitError;
  }
}

}  // namespace capstan
