#include "tests/support/program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "runner/daemon/process_identity.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The first line that the process writes: "Capstan serves http://127.0.0.1:PORT with …".
std::string first_line(int output) {
  FILE* stream = fdopen(output, "r");
  char line[1000] = "";
  const bool has_line = fgets(line, sizeof line, stream);
  std::fclose(stream);
  return has_line ? line : "";
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> environment_with(const std::string& fail_at) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry; ++entry) all.emplace_back(*entry);
  if (!fail_at.empty()) all.push_back("CAPSTAN_FAIL_AT=" + fail_at);
  return all;
}

}  // namespace

CommandResult run_capstan(const std::string& arguments, const std::string& redirection) {
  const TemporaryDirectory directory;
  const std::string out = directory.path() / "out";
  const std::string errors = directory.path() / "errors";
  const int status = std::system(
      (CAPSTAN_PROGRAM " " + arguments + " >" + out + " 2>" + errors + " " + redirection).c_str());
  return {WEXITSTATUS(status), content(out), content(errors)};
}

Daemon::Daemon(const std::filesystem::path& data, const std::vector<std::string>& more,
               const std::string& fail_at) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  std::vector<std::string> words = {"capstan", "serve", "--data", data};
  words.insert(words.end(), more.begin(), more.end());
  if (std::find(more.begin(), more.end(), "--cores") == more.end() &&
      std::find(more.begin(), more.end(), "--executor") == more.end())
    words.insert(words.end(), {"--cores", "3"});
  if (std::find(more.begin(), more.end(), "--listen") == more.end())
    words.insert(words.end(), {"--listen", "127.0.0.1:0"});
  std::vector<std::string> environment = environment_with(fail_at);
  if (posix_spawn(&pid_, CAPSTAN_PROGRAM, &actions, nullptr, pointers(words).data(),
                  pointers(environment).data()) != 0)
    throw std::runtime_error("cannot start " CAPSTAN_PROGRAM);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  const std::string line = first_line(ends[0]);
  char url[200] = "";
  if (std::sscanf(line.c_str(), "Capstan serves %199s", url) != 1) throw DaemonDied(line, wait());
  url_ = url;
}

Daemon::~Daemon() {
  if (pid_ != 0) end_with(SIGKILL);
}

int Daemon::end_with(int signal) {
  kill(pid_, signal);
  return wait();
}

bool Daemon::ends_within(std::chrono::milliseconds time) {
  return wait_for_end(identify(pid_).value_or(ProcessIdentity{pid_, "", ""}), static_cast<int>(time.count()));
}

int Daemon::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace capstan
