#pragma once
// Gives the memory that responses have freed back to the system (malloc_trim); otherwise the allocator would
// keep some for each thread. Doing so after every response would take a third of the server's time.
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>

namespace capstan {

class FreedMemory {
 public:
  /// From any thread, after each response. Trims at once after a large one.
  void after_response(std::size_t bytes);
  /// To be called repeatedly by one thread. Trims at most four times a second, and only after responses: a
  /// small response, too, may have needed much memory (a phase diagram reads all cases of its study).
  void trim();

 private:
  std::atomic<bool> has_answered_ = false;  ///< since the last trim()
  std::chrono::steady_clock::time_point last_trim_;
  std::mutex trimming_;
};

}  // namespace capstan
