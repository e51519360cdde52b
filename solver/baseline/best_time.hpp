#pragma once
#include <algorithm>
#include <chrono>
#include <limits>

namespace capstan {

/// Seconds of the fastest of the calls that fit into `span` seconds, five at least: other programs only ever
/// add.
template <class Work>
double best_time(double span, Work work) {
  using Clock = std::chrono::steady_clock;
  constexpr int kFewest = 5;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  work();  // into the caches
  double best = std::numeric_limits<double>::infinity();
  const auto begin = Clock::now();
  for (int call = 0; call < kFewest || seconds_since(begin) < span; ++call) {
    const auto start = Clock::now();
    work();
    best = std::min(best, seconds_since(start));
  }
  return best;
}

}  // namespace capstan
