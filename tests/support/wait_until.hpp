#pragma once
// Waits for a condition that another process brings about.
#include <unistd.h>

#include <chrono>

namespace capstan {

/// Checks the condition every millisecond. Returns false if it does not hold within the time.
template <class Condition>
bool wait_until(const Condition& condition, std::chrono::minutes time = std::chrono::minutes(1)) {
  const auto deadline = std::chrono::steady_clock::now() + time;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    usleep(1000);
  }
  return true;
}

}  // namespace capstan
