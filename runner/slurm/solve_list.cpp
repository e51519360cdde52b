#include "runner/slurm/solve_list.hpp"

#include <chrono>
#include <csignal>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "runner/daemon/local_executor.hpp"
#include "runner/slurm/case_list.hpp"
#include "solver/run_directory/attempt_token.hpp"
#include "solver/run_directory/exit_code.hpp"
#include "solver/run_directory/stop_signals.hpp"

namespace capstan {
namespace {

using namespace std::chrono_literals;

/// A process of an earlier attempt ends within seconds once it sees that it was replaced. Until then it may
/// hold the lock of the directory.
constexpr auto kMaxWaitForLock = 2min;

/// Those that ask to stop, and the end of a child.
sigset_t awaited_signals() {
  sigset_t signals = stop_signals();
  sigaddset(&signals, SIGCHLD);
  return signals;
}

/// From now on they are received by sigtimedwait alone. The job script ignores SIGUSR1 until it is replaced
/// by this program.
void block_signals() {
  const sigset_t signals = awaited_signals();
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGUSR1, SIG_DFL);
}

/// Waits up to a second. True if a signal came that asks to stop.
bool is_stop_signalled() {
  const sigset_t signals = awaited_signals();
  const timespec second{1, 0};
  const int signal = sigtimedwait(&signals, nullptr, &second);
  return signal > 0 && signal != SIGCHLD;
}

class Task {
 public:
  explicit Task(std::filesystem::path journal) : journal_(std::move(journal)) {}

  /// Slurm may start a task twice, after its controller was killed. So each start has a token of its own, and
  /// the process of the earlier one publishes nothing any more.
  void solve(const ListedCase& listed) {
    if (!listed.directory.is_attempt(listed.token)) return;
    const std::string own_token = listed.token + "." + new_token();
    listed.directory.begin_attempt(own_token);
    const std::optional<RunHandle> run = start(listed, own_token);
    if (!run) return;
    note_beginning(journal_, listed.token);
    const ProcessEnd end = wait_for(*run);
    if (listed.directory.is_attempt(own_token)) note_end(journal_, listed.token, end);
  }

  bool is_stopped() const { return is_stopped_; }

 private:
  /// Nothing if there is a result already, the attempt is not ours any more, or the lock of the directory did
  /// not become free.
  std::optional<RunHandle> start(const ListedCase& listed, const std::string& own_token) {
    const Claim claim{listed.case_id, "", own_token, 0, ""};
    for (auto waited = 0s; waited < kMaxWaitForLock && !is_stopped_; waited += 1s) try {
        if (listed.directory.result()) {
          note_end(journal_, listed.token, {ProcessEnd::How::exited, kExitDone});
          return std::nullopt;
        }
        if (!listed.directory.is_attempt(own_token)) return std::nullopt;
        return executor_.start(claim, listed.directory);
      } catch (const std::system_error& error) {
        if (error.code() != std::errc::device_or_resource_busy) throw;
        std::cerr << error.what() << std::endl;
        is_stopped_ = is_stop_signalled();
      }
    return std::nullopt;
  }

  ProcessEnd wait_for(const RunHandle& run) {
    for (;;) {
      if (const auto end = executor_.poll(run)) return *end;
      if (!is_stop_signalled()) continue;
      is_stopped_ = true;
      executor_.cancel(run, StopBy::checkpoint);
    }
  }

  const std::filesystem::path journal_;
  LocalExecutor executor_{1};
  bool is_stopped_ = false;
};

}  // namespace

int solve_list(const std::filesystem::path& list, const std::filesystem::path& journal) {
  block_signals();
  Task task(journal);
  for (const ListedCase& listed : read_case_list(list)) {
    if (task.is_stopped()) break;
    task.solve(listed);
  }
  return task.is_stopped() ? kExitInterrupted : kExitDone;
}

}  // namespace capstan
