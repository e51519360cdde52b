#include "solver/observe/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "solver/observe/motion_features.hpp"
#include "solver/observe/shape_vector.hpp"

namespace capstan {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
constexpr double kSameTime = 1e-9;

MotionSample sample_of(const Record& record) {
  return {record["kt"], record["D_xy"], record["theta"], record["psi"]};
}

/// The samples of both runs at the times that both have.
std::pair<MotionSamples, MotionSamples> at_common_times(const History& run, const History& other) {
  std::pair<MotionSamples, MotionSamples> common;
  auto next = other.begin();
  for (const Record& record : run) {
    while (next != other.end() && (*next)["kt"] < record["kt"] - kSameTime) ++next;
    if (next == other.end()) break;
    if ((*next)["kt"] > record["kt"] + kSameTime) continue;
    common.first.push_back(sample_of(record));
    common.second.push_back(sample_of(*next));
  }
  return common;
}

/// Angle between two axes, 0 to pi/2.
double angle_between_axes(double theta, double other) {
  return std::abs(std::remainder(theta - other, std::numbers::pi));
}

/// Half-turns a unit of kt from kStart on; NaN if there is less than half of one.
double frequency(const MotionSamples& samples) {
  const auto first = std::ranges::lower_bound(samples, kStart - kSameTime, {}, &MotionSample::kt);
  if (first == samples.end()) return kUndefined;
  const Samples run(first, samples.end());
  const double half_turns = turns(run);
  return half_turns < 0.5 ? kUndefined : half_turns / (run.back().kt - run.front().kt);
}

}  // namespace

Distance distance_between(const History& run, const History& other) {
  const auto [a, b] = at_common_times(run, other);
  Distance distance{.theta = kUndefined};
  for (std::size_t i = 0; i < a.size(); ++i) {
    distance.Q = std::max(distance.Q, (shape_vector(a[i]) - shape_vector(b[i])).norm());
    distance.D_xy = std::max(distance.D_xy, std::abs(a[i].D_xy - b[i].D_xy));
    if (std::min(a[i].D_xy, b[i].D_xy) >= kClearlyInclined)
      distance.theta = std::fmax(distance.theta, angle_between_axes(a[i].theta, b[i].theta));
  }
  distance.period = std::abs(frequency(a) / frequency(b) - 1);
  if (!a.empty()) distance.until_kt = a.back().kt;
  return distance;
}

}  // namespace capstan
