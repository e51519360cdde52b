#include "tests/support/solve_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/inotify.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <string>

namespace capstan {
namespace {

int watch_files_of(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  const int watch = inotify_init1(IN_CLOEXEC);
  if (watch < 0 || inotify_add_watch(watch, directory.c_str(), IN_CREATE | IN_MODIFY | IN_MOVED_TO) < 0)
    throw std::runtime_error("cannot watch " + directory.string());
  return watch;
}

pid_t start(const std::filesystem::path& case_file, const std::filesystem::path& directory,
            const std::vector<std::string>& options) {
  std::vector<std::string> words = {"capstan", "solve", case_file, "--out", directory};
  words.insert(words.end(), options.begin(), options.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 2, (directory.string() + ".log").c_str(),
                                   O_WRONLY | O_CREAT | O_APPEND, 0600);
  pid_t pid = 0;
  const int failed = posix_spawn(&pid, CAPSTAN_PROGRAM, &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed) throw std::runtime_error("cannot start " CAPSTAN_PROGRAM);
  return pid;
}

/// Reads the pending events. Returns their number.
int events_in(int watch) {
  alignas(inotify_event) std::array<char, 4096> buffer;
  const auto size = read(watch, buffer.data(), buffer.size());
  int events = 0;
  for (ssize_t at = 0; at < size; ++events)
    at += ssize_t(sizeof(inotify_event) + reinterpret_cast<const inotify_event*>(&buffer[at])->len);
  return events;
}

}  // namespace

SolveProcess::SolveProcess(const std::filesystem::path& case_file, const std::filesystem::path& directory,
                           const std::vector<std::string>& options)
    : watch_(watch_files_of(directory)) {
  pid_ = start(case_file, directory, options);
  lifetime_ = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
}

SolveProcess::~SolveProcess() {
  if (pid_ != 0) {
    send(SIGKILL);
    wait();
  }
  close(watch_);
  close(lifetime_);
}

void SolveProcess::wait_for_writes(int count) {
  std::array<pollfd, 2> either{pollfd{watch_, POLLIN, 0}, pollfd{lifetime_, POLLIN, 0}};
  while (count > 0) {
    poll(either.data(), either.size(), -1);
    if (either[0].revents)
      count -= events_in(watch_);
    else
      return;
  }
}

void SolveProcess::send(int signal) { kill(pid_, signal); }

int SolveProcess::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace capstan
