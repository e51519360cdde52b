#pragma once
// Deformation and orientation of the capsule and the angle of its membrane, unwrapped over many turns.
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"
#include "solver/observe/motion_sample.hpp"

namespace capstan {

class StateArchive;

/// Angles are unwrapped from one observation to the next. Between the two the major axis must turn by less
/// than pi/2 and the membrane by less than pi. Where the section is nearly circular (D_xy = 0) the axis has
/// no direction and theta may jump by pi: classify() therefore does not rely on theta alone.
class MotionTracker {
 public:
  /// \param initial 3 x #V, the positions at the start of the run, inclined by pi/4
  MotionTracker(const Points& initial, const Faces& faces);

  /// Deformation and angles at time kt. The next angles are unwrapped from these.
  /// \param positions 3 x #V
  MotionSample observe(double kt, const Points& positions);

  /// The same for a time soon after the last observation, without a change of the tracker.
  MotionSample look(double kt, const Points& positions) const {
    return MotionTracker(*this).observe(kt, positions);
  }

  void save(StateArchive& archive) const;
  void load(const StateArchive& archive);

 private:
  Faces faces_;
  std::vector<int> equator_;  ///< vertices that start near the plane of shear
  double theta_;              ///< radians, unwrapped

  /// Angle of each of those vertices against the major axis, after the ellipse is scaled to a circle:
  /// radians, unwrapped.
  std::vector<double> angles_;
  double initial_mean_angle_;  ///< radians
};

}  // namespace capstan
