#include "solver/observe/shape_vector.hpp"

#include <algorithm>
#include <cmath>

namespace capstan {
namespace {

double distance_of_segment_to_origin(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  if (along.squaredNorm() == 0) return a.norm();
  return (a + std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0) * along).norm();
}

}  // namespace

Eigen::Vector2d shape_vector(const MotionSample& sample) {
  return sample.D_xy * Eigen::Vector2d(std::cos(2 * sample.theta), std::sin(2 * sample.theta));
}

double smallest_distance_to_origin(Samples samples) {
  double smallest = shape_vector(samples.front()).norm();
  for (size_t n = 0; n + 1 < samples.size(); ++n)
    smallest = std::min(
        smallest, distance_of_segment_to_origin(shape_vector(samples[n]), shape_vector(samples[n + 1])));
  return smallest;
}

bool hardly_moves(Samples samples, double share) {
  const Eigen::Vector2d last = shape_vector(samples.back());
  return std::ranges::all_of(samples, [&](const MotionSample& sample) {
    return (shape_vector(sample) - last).norm() <= share * last.norm();
  });
}

}  // namespace capstan
