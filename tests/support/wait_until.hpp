#pragma once
// Waits for a condition that another process brings about.
#include <unistd.h>

#include <chrono>

namespace capstan {

/// Checks the condition every millisecond. Returns false if it does not hold within a minute.
template <class Condition>
bool wait_until(const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    usleep(1000);
  }
  return true;
}

}  // namespace capstan
