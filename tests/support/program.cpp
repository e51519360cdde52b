#include "tests/support/program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The first line that the process writes: "Capstan serves http://127.0.0.1:PORT with …".
std::string announced_url(int output) {
  FILE* stream = fdopen(output, "r");
  char line[1000] = "";
  char url[200] = "";
  if (!fgets(line, sizeof line, stream) || std::sscanf(line, "Capstan serves %199s", url) != 1)
    throw std::runtime_error(std::string("the daemon said: ") + line);
  std::fclose(stream);
  return url;
}

}  // namespace

CommandResult run_capstan(const std::string& arguments) {
  const TemporaryDirectory directory;
  const std::string out = directory.path() / "out";
  const std::string errors = directory.path() / "errors";
  const int status = std::system((CAPSTAN_PROGRAM " " + arguments + " >" + out + " 2>" + errors).c_str());
  return {WEXITSTATUS(status), content(out), content(errors)};
}

Daemon::Daemon(const std::filesystem::path& data, const std::vector<std::string>& more,
               const std::string& listen) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  std::vector<std::string> words = {"capstan", "serve", "--listen", listen,
                                    "--cores", "3",     "--data",   data.string()};
  words.insert(words.end(), more.begin(), more.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  if (posix_spawn(&pid_, CAPSTAN_PROGRAM, &actions, nullptr, arguments.data(), environ) != 0)
    throw std::runtime_error("cannot start " CAPSTAN_PROGRAM);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  url_ = announced_url(ends[0]);
}

Daemon::~Daemon() {
  if (pid_ != 0) end_with(SIGKILL);
}

int Daemon::end_with(int signal) {
  kill(pid_, signal);
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace capstan
