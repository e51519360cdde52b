#pragma once
// The program CAPSTAN_PROGRAM as a process: one command, or a daemon that can be killed.
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace capstan {

struct CommandResult {
  int exit_code = -1;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs `capstan ARGUMENTS` in a shell and waits for its end.
/// \param redirection  of the shell, such as ">/dev/full"; then `output` is empty
CommandResult run_capstan(const std::string& arguments, const std::string& redirection = "");

/// The daemon ended before it printed its address; `exit_code` as returned by Daemon::end_with.
struct DaemonDied : std::runtime_error {
  DaemonDied(const std::string& said, int code)
      : std::runtime_error("the daemon said: " + said), exit_code(code) {}
  int exit_code;
};

/// `capstan serve` on a free port.
class Daemon {
 public:
  /// Returns when the daemon serves. Throws DaemonDied if it ends before.
  /// \param more     further arguments; by default "--cores 3 --listen 127.0.0.1:0"
  /// \param fail_at  fail point at which it is killed, "NAME:N" (runner/store/fail_point.hpp)
  explicit Daemon(const std::filesystem::path& data, const std::vector<std::string>& more = {},
                  const std::string& fail_at = "");
  ~Daemon();
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  const std::string& url() const { return url_; }
  pid_t pid() const { return pid_; }

  /// Sends the signal and waits for the end: the exit code, or minus the signal that killed it.
  int end_with(int signal);

  /// Waits for the end for that time. Returns false if the daemon still runs.
  bool ends_within(std::chrono::milliseconds time);

 private:
  int wait();

  pid_t pid_ = 0;
  std::string url_;
};

}  // namespace capstan
