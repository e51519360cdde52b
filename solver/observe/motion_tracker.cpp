#include "solver/observe/motion_tracker.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "solver/observe/deformation.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {
namespace {

using std::numbers::pi;

constexpr double kRound = 1e-9;  // below this D_xy the direction of the major axis is rounding noise

/// The angle equal to `principal` up to multiples of `period` that is nearest to `previous`. Its last bits do
/// not depend on `previous`.
double unwrapped(double principal, double previous, double period) {
  return principal + period * std::round((previous - principal) / period);
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Angle of a point against the major axis after the ellipse is scaled to a circle, radians in [-pi, pi].
double angle_on_ellipse(const Vec3& point, const InertiaEllipse& ellipse, double theta) {
  const Vec3 r = point - ellipse.centre;
  const double along = std::cos(theta) * r.x() + std::sin(theta) * r.y();
  const double across = std::cos(theta) * r.y() - std::sin(theta) * r.x();
  return std::atan2(across / ellipse.minor, along / ellipse.major);
}

std::vector<int> points_near_shear_plane(const Points& positions) {
  // Less than the length of an edge at 642 vertices. Every icosphere has vertices in the plane itself.
  constexpr double kNear = 0.1;
  std::vector<int> points;
  for (int vertex = 0; vertex < positions.cols(); ++vertex)
    if (std::abs(positions(2, vertex)) < kNear) points.push_back(vertex);
  return points;
}

}  // namespace

MotionTracker::MotionTracker(const Points& initial, const Faces& faces)
    : faces_(faces),
      equator_(points_near_shear_plane(initial)),
      theta_(pi / 4),
      angles_(equator_.size(), 0.0) {
  observe(0, initial);
  initial_mean_angle_ = mean(angles_);
}

MotionSample MotionTracker::observe(double kt, const Points& positions) {
  const InertiaEllipse ellipse = inertia_ellipse(positions, faces_);
  const auto [D_xy, theta] = deformation(ellipse);
  if (!(D_xy < kRound)) theta_ = unwrapped(theta, theta_, pi);
  for (size_t i = 0; i < equator_.size(); ++i)
    angles_[i] = unwrapped(angle_on_ellipse(positions.col(equator_[i]), ellipse, theta_), angles_[i], 2 * pi);
  return {.kt = kt, .D_xy = D_xy, .theta = theta_, .psi = mean(angles_) - initial_mean_angle_};
}

void MotionTracker::save(StateArchive& archive) const {
  archive.put("motion/theta", theta_);
  archive.put("motion/angles", angles_);
}

void MotionTracker::load(const StateArchive& archive) {
  theta_ = archive.number("motion/theta");
  const auto angles = archive.get("motion/angles");
  angles_.assign(angles.begin(), angles.end());
}

}  // namespace capstan
