#pragma once
// The motion at a step of the run. A run is classified by these samples, so the label does not depend on the
// intervals of records and shapes.
#include <span>
#include <vector>

namespace capstan {

struct MotionSample {
  double kt = 0;
  double D_xy = 0;   ///< Taylor deformation (L - l)/(L + l) in the plane of shear, paper eq. 5
  double theta = 0;  ///< angle of the major axis with x, radians, unwrapped
  double psi = 0;  ///< mean angle of the membrane against the major axis, radians, unwrapped, 0 at the start
  bool operator==(const MotionSample&) const = default;
};
using MotionSamples = std::vector<MotionSample>;
using Samples = std::span<const MotionSample>;  ///< consecutive samples, in the order of time

/// Minimum shear time kt between two samples.
inline constexpr double kSampleInterval = 0.02;

}  // namespace capstan
