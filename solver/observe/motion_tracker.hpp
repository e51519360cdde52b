#pragma once
// Follows the capsule's orientation and the membrane's turning through whole turns.
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"
#include "solver/observe/history.hpp"

namespace capstan {

class StateArchive;

/// Angles are unwrapped from one observation to the next, which must be close enough in time for the major
/// axis to turn by less than pi/2 and the membrane by less than pi; near a circular section (D_xy = 0) the
/// axis has no direction and its branch is a coin toss, which is why classify() does not rely on theta alone.
class MotionTracker {
 public:
  /// \param initial 3 x #V, the positions at the start of the run, inclined by pi/4
  MotionTracker(const Points& initial, const Faces& faces);

  /// Shape and angles now; iterations and error are left to the flow.
  Record observe(double kt, const Points& positions);

  /// The same at a time soon after the last observation, without becoming one.
  Record look(double kt, const Points& positions) const {
    return MotionTracker(*this).observe(kt, positions);
  }

  void save(StateArchive& archive) const;
  void load(const StateArchive& archive);

 private:
  Faces faces_;
  std::vector<int> equator_;  ///< material points that start near the plane of shear
  double theta_;              ///< unwrapped

  /// Of those points against the major axis, the ellipse scaled to a circle, unwrapped.
  std::vector<double> angles_;
  double initial_mean_angle_;
};

}  // namespace capstan
