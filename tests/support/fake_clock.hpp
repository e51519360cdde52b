#pragma once
// A clock that stands still until it is moved.
#include "runner/queue/clock.hpp"

namespace capstan {

class FakeClock : public Clock {
 public:
  Time now() const override { return now_; }
  void advance(std::chrono::milliseconds duration) { now_ += duration; }

 private:
  Time now_{std::chrono::hours(24 * 365 * 50)};
};

}  // namespace capstan
