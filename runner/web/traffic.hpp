#pragma once
// What the server has done since the process began, in numbers.
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace capstan {

class Traffic {
 public:
  void count(int status, std::chrono::duration<double> time);

  std::atomic<int> connections = 0;  ///< that have a thread
  std::atomic<int> streams = 0;      ///< of events, of those

  /// In Prometheus' text format, with the memory and the open files of the process.
  std::string metrics_text();

 private:
  std::mutex mutex_;
  std::map<int, std::uint64_t> requests_;  ///< by status
  double seconds_ = 0;
};

/// There is one a process, as of its memory.
Traffic& traffic();

}  // namespace capstan
