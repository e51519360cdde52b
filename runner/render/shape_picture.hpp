#pragma once
// Pictures of the capsule in the plane of shear, which is drawn to scale.
#include <string>
#include <vector>

#include "runner/render/gnuplot.hpp"
#include "runner/render/membrane_section.hpp"

namespace capstan {

/// The section of one case, with its name in the key.
struct Profile {
  std::string title;
  std::vector<ClosedCurve> section;
  PlanePoint marker;  ///< a material point of the membrane
};

/// The profiles of all cases at one time.
struct ProfilePanel {
  std::string title;
  std::vector<Profile> profiles;
};

/// gnuplot's script for the panels, at most three in a row, all at one scale. A dot is the marker.
std::string profile_script(const std::vector<ProfilePanel>& panels, const PictureFormat& format);

/// A material point in time.
struct TrajectoryPoint {
  PlanePoint place, velocity;  ///< / a, / (a k)
};

/// The trajectory of the marker of one case, with its name in the key.
struct Trajectory {
  std::string title;
  std::vector<TrajectoryPoint> points;
};

/// gnuplot's script for the trajectories, with an arrow at each point along its velocity.
std::string trajectory_script(const std::vector<Trajectory>& trajectories, const PictureFormat& format);

}  // namespace capstan
