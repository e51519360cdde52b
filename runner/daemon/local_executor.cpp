#include "runner/daemon/local_executor.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "solver/run_directory/directory_lock.hpp"
#include "solver/run_directory/parent_daemon.hpp"
#include "solver/run_directory/stop_signals.hpp"

namespace capstan {
namespace {

void check(int code, const std::string& operation) {
  if (code != 0) throw std::system_error(code, std::generic_category(), operation);
}

/// Nothing to read, all output into the log, the lock, and no other descriptor: above all no client's
/// connection.
class FileActions {
 public:
  FileActions(const std::filesystem::path& log, int lock) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    posix_spawn_file_actions_adddup2(&actions_, 1, 2);
    posix_spawn_file_actions_adddup2(&actions_, lock, DirectoryLock::kInheritedDescriptor);
    posix_spawn_file_actions_addclosefrom_np(&actions_, DirectoryLock::kInheritedDescriptor + 1);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// A process group of its own, so that Ctrl-C reaches the daemon alone. All signals have their default
/// action, and those that ask for a checkpoint are blocked until the process has its handlers.
class Attributes {
 public:
  Attributes() {
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes_, 0);
    const sigset_t blocked = stop_signals();
    posix_spawnattr_setsigmask(&attributes_, &blocked);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigdefault(&attributes_, &all);
  }
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

/// One thread a run: the cores are shared by running cases side by side. The token is the daemon's alone: the
/// environment of a process can be read in /proc.
std::vector<std::string> worker_environment() {
  std::vector<std::string> environment;
  for (char** entry = environ; *entry; ++entry) {
    const std::string_view variable(*entry);
    if (!variable.starts_with("OMP_NUM_THREADS=") && !variable.starts_with("CAPSTAN_TOKEN"))
      environment.emplace_back(variable);
  }
  environment.emplace_back("OMP_NUM_THREADS=1");
  environment.push_back(std::string(kDaemonVariable) + "=" + std::to_string(getpid()));
  return environment;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

ProcessEnd end_of(int status) {
  if (WIFSIGNALED(status)) return {ProcessEnd::How::signalled, WTERMSIG(status)};
  return {ProcessEnd::How::exited, WEXITSTATUS(status)};
}

}  // namespace

LocalExecutor::LocalExecutor(std::filesystem::path program) : program_(std::move(program)) {}

RunHandle LocalExecutor::start(const RunDirectory& directory) {
  DirectoryLock lock(directory);
  if (!lock.take()) check(EBUSY, "another process computes in " + directory.path().string());
  std::vector<std::string> words = {"capstan", "solve", directory.case_file(), "--out", directory.path()};
  std::vector<std::string> environment = worker_environment();
  pid_t pid = 0;
  check(posix_spawn(&pid, program_.c_str(), FileActions(directory.log_file(), lock.descriptor()).get(),
                    Attributes().get(), pointers(words).data(), pointers(environment).data()),
        "cannot start " + program_.string());
  const ProcessIdentity child = identify(pid).value_or(ProcessIdentity{pid, "", ""});
  const RunHandle run = to_text(child);
  children_[run] = child;
  return run;
}

std::optional<ProcessEnd> LocalExecutor::poll(const RunHandle& run) {
  const auto child = children_.find(run);
  if (child == children_.end()) {
    const auto stranger = process_from_text(run);
    if (stranger && is_alive(*stranger)) return std::nullopt;
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

bool LocalExecutor::wait_until_free(const RunDirectory& directory) {
  if (!std::filesystem::exists(directory.path())) return true;
  constexpr std::chrono::milliseconds kStep{5}, kMax{5000};
  DirectoryLock lock(directory);
  for (std::chrono::milliseconds waited{0}; waited < kMax; waited += kStep) {
    if (lock.take()) return true;
    std::this_thread::sleep_for(kStep);
  }
  return false;
}

/// A child that has not been reaped keeps its process id, so it needs no look into /proc, which may fail.
void LocalExecutor::cancel(const RunHandle& run, StopBy stop) {
  const auto process = process_from_text(run);
  if (!process || (!children_.contains(run) && !is_alive(*process))) return;
  ::kill(-process->pid, stop == StopBy::kill ? SIGKILL : SIGTERM);
  constexpr int kMax = 5000;  // ms; a killed process that waits for a disk
  if (stop == StopBy::kill) wait_for_end(*process, kMax);
}

}  // namespace capstan
