#include "solver/fluid/stokes/point_sums.hpp"

#include <algorithm>

namespace capstan {
namespace {

/// The loops for the widest instruction set of this processor.
const PointLoops& loops() {
  static const PointLoops& widest = *supported_point_loops().back();
  return widest;
}

Components components(const PointArray& points) { return {points.x(), points.y(), points.z()}; }

}  // namespace

std::vector<const PointLoops*> supported_point_loops() {
  std::vector<const PointLoops*> supported = {&kLoops_x86_64};
#ifndef __clang__  // clang 14 does not know these names of processor levels
  if (__builtin_cpu_supports("x86-64-v3")) supported.push_back(&kLoops_x86_64_v3);
  if (__builtin_cpu_supports("x86-64-v4")) supported.push_back(&kLoops_x86_64_v4);
#endif
  return supported;
}

void PointArray::assign(const Eigen::Matrix3Xd& values) {
  const auto count = size_t(values.cols()), padded = (count + kLanes - 1) / kLanes * kLanes;
  for (std::vector<float>* component : {&x_, &y_, &z_}) component->resize(padded);
  for (size_t n = 0; n < count; ++n) {
    x_[n] = float(values(0, n));
    y_[n] = float(values(1, n));
    z_[n] = float(values(2, n));
  }
  for (std::vector<float>* component : {&x_, &y_, &z_})
    std::fill(component->begin() + count, component->end(), 0.f);
}

Eigen::Vector3f sum_stokeslets(const PointArray& points, const PointArray& strengths,
                               const Eigen::Vector3f& x0) {
  return sum_stokeslets(points.padded_size(), components(points), components(strengths), x0);
}

Eigen::Vector3f sum_stokeslets(int count, const Components& points, const Components& strengths,
                               const Eigen::Vector3f& x0) {
  Eigen::Vector3f sum;
  loops().stokeslets(count, points, strengths, x0.data(), sum.data());
  return sum;
}

Eigen::Vector3f sum_stresslets(const PointArray& points, const PointArray& area_vectors,
                               const PointArray& velocities, const Eigen::Vector3f& x0,
                               const Eigen::Vector3f& u0) {
  Eigen::Vector3f sum;
  loops().stresslets(points.padded_size(), components(points), components(area_vectors),
                     components(velocities), x0.data(), u0.data(), sum.data());
  return sum;
}

int mark_within_reach(const PointArray& points, const std::vector<float>& reach_squared,
                      const Eigen::Vector3f& x0, std::vector<unsigned char>& marks) {
  marks.resize(size_t(points.padded_size()));
  return loops().mark_within_reach(points.padded_size(), components(points), reach_squared.data(), x0.data(),
                                   marks.data());
}

}  // namespace capstan
