#pragma once
// The clock of the daemon; tests replace it by one that they move.
#include <chrono>

namespace capstan {

using Time = std::chrono::sys_time<std::chrono::milliseconds>;

class Clock {
 public:
  virtual ~Clock() = default;
  /// The time of day. It jumps when somebody sets the system's clock.
  virtual Time now() const = 0;
  /// A monotonic time for measuring durations. It stands still while the machine sleeps. Not to be stored: it
  /// counts from the start of the machine.
  virtual std::chrono::milliseconds elapsed() const = 0;
};

class SystemClock : public Clock {
 public:
  Time now() const override {
    return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
  }
  std::chrono::milliseconds elapsed() const override {
    return std::chrono::floor<std::chrono::milliseconds>(std::chrono::steady_clock::now().time_since_epoch());
  }
};

}  // namespace capstan
