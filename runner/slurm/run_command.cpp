#include "runner/slurm/run_command.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "runner/daemon/child_environment.hpp"

namespace capstan {
namespace {

using std::chrono::milliseconds;
using SteadyClock = std::chrono::steady_clock;

/// The reading end belongs to this process, the writing end to the child.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) ends_ = {-1, -1};
  }
  ~Pipe() {
    close_writing_end();
    if (ends_[0] >= 0) close(ends_[0]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading_end() const { return ends_[0]; }
  int writing_end() const { return ends_[1]; }
  void close_writing_end() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{};
};

/// The child is in a process group of its own, so that it can be killed together with its children.
class Child {
 public:
  Child(std::vector<std::string> words, const Pipe& output, const Pipe& errors) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output.writing_end(), 1);
    posix_spawn_file_actions_adddup2(&actions, errors.writing_end(), 2);
    posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    std::vector<std::string> environment = child_environment();
    // Such as SQUEUE_PARTITION, with which squeue would not list all jobs.
    std::erase_if(environment, [](const std::string& entry) { return entry.starts_with("SQUEUE_"); });
    error_ = posix_spawnp(&pid_, words[0].c_str(), &actions, &attributes, pointers_to(words).data(),
                          pointers_to(environment).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }

  int error() const { return error_; }
  void kill() const { ::kill(-pid_, SIGKILL); }
  /// Waits for the end. Returns the exit code, or 128 and the signal.
  int wait() const {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  pid_t pid_ = 0;
  int error_ = 0;
};

/// Whether a signal waits that asks the daemon to end (loop.hpp blocks them).
bool is_end_asked() {
  sigset_t pending;
  return sigpending(&pending) == 0 &&
         (sigismember(&pending, SIGTERM) == 1 || sigismember(&pending, SIGINT) == 1);
}

/// Reads both until the child has closed them. False at the deadline, and if the daemon is asked to end: a
/// job that was submitted nevertheless is found by its name.
bool read_until_closed(const Pipe& output, const Pipe& errors, SteadyClock::time_point deadline,
                       CommandOutcome& result) {
  std::array<pollfd, 2> ends{{{output.reading_end(), POLLIN, 0}, {errors.reading_end(), POLLIN, 0}}};
  const std::array<std::string*, 2> texts{&result.output, &result.errors};
  std::array<char, 1 << 16> part;
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    constexpr milliseconds kMaxWait{1000};
    const auto left = std::min(kMaxWait, std::chrono::ceil<milliseconds>(deadline - SteadyClock::now()));
    if (left.count() <= 0) return false;
    if (poll(ends.data(), ends.size(), static_cast<int>(left.count())) == 0) {
      if (is_end_asked()) return false;
      continue;
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].fd < 0 || ends[i].revents == 0) continue;
      const ssize_t count = read(ends[i].fd, part.data(), part.size());
      if (count > 0) texts[i]->append(part.data(), static_cast<std::size_t>(count));
      if (count == 0) ends[i].fd = -1;  // poll ignores it from now on
    }
  }
  return true;
}

}  // namespace

CommandOutcome run_command(const std::vector<std::string>& words, milliseconds max_time) {
  const SteadyClock::time_point deadline = SteadyClock::now() + max_time;
  Pipe output, errors;
  const Child child(words, output, errors);
  if (child.error() != 0) return {.errors = words[0] + ": " + std::strerror(child.error())};
  output.close_writing_end();
  errors.close_writing_end();
  CommandOutcome result;
  result.is_finished = read_until_closed(output, errors, deadline, result);
  if (!result.is_finished) child.kill();
  result.exit_code = child.wait();
  if (!result.is_finished)
    result.errors = words[0] + " did not end within " + std::to_string(max_time.count() / 1000) + " s";
  return result;
}

}  // namespace capstan
