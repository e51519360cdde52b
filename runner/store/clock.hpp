#pragma once
// The time of day and the time that has passed, so that tests can hold both still.
#include <chrono>

namespace capstan {

using Time = std::chrono::sys_time<std::chrono::milliseconds>;

class Clock {
 public:
  virtual ~Clock() = default;
  virtual Time now() const = 0;
  /// Grows evenly, whoever sets the clock, and not while the machine sleeps. To be measured with, not stored.
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
