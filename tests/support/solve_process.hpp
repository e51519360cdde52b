#pragma once
// The real `capstan solve` as a process that can be killed between any two of its writes.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

/// `capstan solve CASE --out DIRECTORY OPTIONS`. The constructor starts it; its standard error goes to
/// DIRECTORY.log.
class SolveProcess {
 public:
  SolveProcess(const std::filesystem::path& case_file, const std::filesystem::path& directory,
               const std::vector<std::string>& options = {});
  ~SolveProcess();
  SolveProcess(const SolveProcess&) = delete;
  SolveProcess& operator=(const SolveProcess&) = delete;

  /// Waits until the process has created, written or renamed files of its directory that many times, or has
  /// ended.
  void wait_for_writes(int count);

  /// Sends the signal. No effect if the process has ended.
  void send(int signal);

  /// Waits for the end. Returns the exit code, or minus the signal that killed the process.
  int wait();

 private:
  pid_t pid_ = 0;
  int watch_;     ///< inotify descriptor of the directory
  int lifetime_;  ///< pidfd; readable when the process has ended
};

}  // namespace capstan
