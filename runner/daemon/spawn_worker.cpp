#include "runner/daemon/spawn_worker.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <system_error>
#include <vector>

#include "runner/daemon/child_environment.hpp"
#include "solver/run_directory/attempt_token.hpp"
#include "solver/run_directory/directory_lock.hpp"
#include "solver/run_directory/parent_daemon.hpp"
#include "solver/run_directory/stop_signals.hpp"

namespace capstan {
namespace {

/// Descriptors of the worker: /dev/null for reading, the log for all output, the lock. No other descriptor of
/// the daemon is passed on, above all no client's connection.
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

/// The worker is in a process group of its own, so that Ctrl-C reaches the daemon only. All signals have
/// their default action; those that ask for a checkpoint are blocked until the worker has installed its
/// handlers.
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

/// A worker uses one thread, because the cores are shared by simultaneous runs.
std::vector<std::string> worker_environment(const std::string& token) {
  std::vector<std::string> environment = child_environment();
  std::erase_if(environment, [](const std::string& entry) { return entry.starts_with("OMP_NUM_THREADS="); });
  environment.emplace_back("OMP_NUM_THREADS=1");
  environment.push_back(std::string(kDaemonVariable) + "=" + std::to_string(getpid()));
  environment.push_back(std::string(kTokenVariable) + "=" + token);
  return environment;
}

}  // namespace

pid_t spawn_worker(const std::filesystem::path& program, const RunDirectory& directory,
                   const std::string& token, int lock) {
  std::vector<std::string> words = {"capstan", "solve", directory.case_file(), "--out", directory.path()};
  std::vector<std::string> environment = worker_environment(token);
  pid_t pid = 0;
  const int error =
      posix_spawn(&pid, program.c_str(), FileActions(directory.log_file(), lock).get(), Attributes().get(),
                  pointers_to(words).data(), pointers_to(environment).data());
  if (error != 0) throw std::system_error(error, std::generic_category(), "cannot start " + program.string());
  return pid;
}

}  // namespace capstan
