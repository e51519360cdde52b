#pragma once
// The motion as the steps of a run saw it, to classify it by: whatever is recorded, its samples are the same.
#include <span>
#include <vector>

namespace capstan {

struct MotionSample {
  double kt = 0;
  double D_xy = 0;
  double theta = 0;  ///< radians, unwrapped, as in Record
  double psi = 0;    ///< radians, unwrapped, as in Record
  bool operator==(const MotionSample&) const = default;
};
using MotionSamples = std::vector<MotionSample>;
using Samples = std::span<const MotionSample>;  ///< a part of them, in the order of time

/// Steps that are shorter than this (k dt) are passed over until as much time has gone by.
inline constexpr double kSampleInterval = 0.02;

}  // namespace capstan
