#pragma once
// The real program (with the fake solver) as a process: one command, or a daemon that can be killed.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

struct CommandResult {
  int exit_code = -1;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs `capstan ARGUMENTS` in a shell, until it ends.
CommandResult run_capstan(const std::string& arguments);

/// `capstan serve` on a free port of its own.
class Daemon {
 public:
  /// Returns when it answers. \param more  further arguments of `capstan serve`
  explicit Daemon(const std::filesystem::path& data, const std::vector<std::string>& more = {},
                  const std::string& listen = "127.0.0.1:0");
  ~Daemon();
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  const std::string& url() const { return url_; }
  pid_t pid() const { return pid_; }

  /// Sends the signal and waits for the end: the exit code, or minus the signal that killed it.
  int end_with(int signal);

 private:
  pid_t pid_ = 0;
  std::string url_;
};

}  // namespace capstan
