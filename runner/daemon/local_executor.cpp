#include "runner/daemon/local_executor.hpp"

#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include "runner/daemon/spawn_worker.hpp"
#include "solver/run_directory/directory_lock.hpp"

namespace capstan {
namespace {

ProcessEnd end_of(int status) {
  if (WIFSIGNALED(status)) return {ProcessEnd::How::signalled, WTERMSIG(status)};
  return {ProcessEnd::How::exited, WEXITSTATUS(status)};
}

}  // namespace

LocalExecutor::LocalExecutor(int cores, std::filesystem::path program)
    : cores_(static_cast<std::size_t>(cores)), program_(std::move(program)) {}

RunHandle LocalExecutor::start(const Claim& claim, const RunDirectory& directory) {
  DirectoryLock lock(directory);
  if (!lock.take())
    throw std::system_error(EBUSY, std::generic_category(),
                            "another process computes in " + directory.path().string());
  directory.remove_partial_files();
  const pid_t pid = spawn_worker(program_, directory, claim.token, lock.descriptor());
  const ProcessIdentity child = identify(pid).value_or(ProcessIdentity{pid, "", ""});
  const RunHandle run = to_text(child);
  children_[run] = child;
  return run;
}

std::optional<ProcessEnd> LocalExecutor::poll(const RunHandle& run) {
  const auto child = children_.find(run);
  if (child == children_.end()) {
    const auto process = process_from_text(run);  // started by an earlier daemon
    if (process && is_alive(*process)) return std::nullopt;
    return ProcessEnd{};
  }
  int status = 0;
  const pid_t ended = waitpid(child->second.pid, &status, WNOHANG);
  if (ended == 0) return std::nullopt;
  children_.erase(child);
  return ended > 0 ? end_of(status) : ProcessEnd{};
}

std::optional<RunUsage> LocalExecutor::usage(const RunHandle& run) {
  const auto process = process_from_text(run);
  const auto used = process ? usage_of(*process) : std::nullopt;
  if (!used) return std::nullopt;
  return RunUsage{used->cpu_seconds, used->resident_mb};
}

RunPlace LocalExecutor::place(const RunHandle& run) const {
  return {.kind = "running", .details = "process " + run.substr(0, run.find(':'))};
}

bool LocalExecutor::wait_until_free(const RunDirectory& directory) {
  if (!std::filesystem::exists(directory.path())) return true;
  constexpr std::chrono::milliseconds kStep{5}, kMaxWait{5000};
  DirectoryLock lock(directory);
  for (std::chrono::milliseconds waited{0}; waited < kMaxWait; waited += kStep) {
    if (lock.take()) return true;
    std::this_thread::sleep_for(kStep);
  }
  return false;
}

/// A child that has not been reaped keeps its process id. So the signal cannot reach another process, and the
/// child need not be identified in /proc, which may fail.
void LocalExecutor::cancel(const RunHandle& run, StopBy stop) {
  const auto process = process_from_text(run);
  if (!process || (!children_.contains(run) && !is_alive(*process))) return;
  ::kill(-process->pid, stop == StopBy::kill ? SIGKILL : SIGTERM);
  constexpr int kMaxWait = 5000;  // ms; a killed process may be waiting for a disk
  if (stop == StopBy::kill) wait_for_end(*process, kMaxWait);
}

}  // namespace capstan
