#pragma once
// A clock that stands still until the test moves it.
#include "runner/store/clock.hpp"

namespace capstan {

class FakeClock : public Clock {
 public:
  Time now() const override { return now_; }
  std::chrono::milliseconds elapsed() const override { return elapsed_; }
  void advance(std::chrono::milliseconds duration) { jump(duration), elapsed_ += duration; }
  /// Sets the wall clock, as an administrator would; `elapsed` does not change.
  void jump(std::chrono::milliseconds difference) { now_ += difference; }

 private:
  Time now_{std::chrono::hours(24 * 365 * 50)};
  std::chrono::milliseconds elapsed_{0};
};

}  // namespace capstan
