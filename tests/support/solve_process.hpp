#pragma once
// The real `capstan solve` as a process that can be killed between any two of its writes.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

/// `capstan solve CASE --out DIRECTORY OPTIONS`, started at once; what it says goes to DIRECTORY.log.
class SolveProcess {
 public:
  SolveProcess(const std::filesystem::path& case_file, const std::filesystem::path& directory,
               const std::vector<std::string>& options = {});
  ~SolveProcess();
  SolveProcess(const SolveProcess&) = delete;
  SolveProcess& operator=(const SolveProcess&) = delete;

  /// Returns when the process has done so many things to the files of its directory, or has ended.
  void wait_for_writes(int count);

  /// Sends the signal; a process that has ended takes no notice.
  void send(int signal);

  /// Waits for the end: the exit code, or minus the signal that killed it.
  int wait();

 private:
  pid_t pid_ = 0;
  int watch_;     ///< inotify: what happens in the directory
  int lifetime_;  ///< pidfd: readable when the process has ended
};

}  // namespace capstan
