#pragma once
// Timing of short functions on a machine that also runs other programs.
#include <omp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <limits>

namespace capstan {

/// The time on a clock for measurements, in seconds. With one thread it is the processor time of the process,
/// which other programs hardly lengthen; several threads wait for each other, so that only elapsed time is
/// their time.
inline double measuring_clock() {
  timespec now{};
  clock_gettime(omp_get_max_threads() == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Seconds of the fastest call of each function. The functions are called in turn for `span` seconds, and at
/// least five times each, so that other programs slow down all of them alike. The minimum is taken because
/// other programs can only lengthen a call.
template <class... Work>
std::array<double, sizeof...(Work)> best_times(double span, Work... work) {
  using Clock = std::chrono::steady_clock;
  constexpr int kMinTurns = 5;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  std::array<double, sizeof...(Work)> best;
  best.fill(std::numeric_limits<double>::infinity());
  const auto begin = Clock::now();
  for (int turn = 0; turn < kMinTurns || seconds_since(begin) < span; ++turn) {
    std::size_t which = 0;
    const auto take_turn = [&](auto& one) {
      const double start = measuring_clock();
      one();
      best[which] = std::min(best[which], measuring_clock() - start);
      ++which;
    };
    (take_turn(work), ...);
  }
  return best;
}

template <class Work>
double best_time(double span, Work work) {
  return best_times(span, work)[0];
}

}  // namespace capstan
