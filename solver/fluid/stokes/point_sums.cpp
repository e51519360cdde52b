#include "solver/fluid/stokes/point_sums.hpp"

#include <algorithm>

#include "solver/fluid/stokes/point_loops.hpp"

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

void PointArray::resize(int size) {
  for (std::vector<float>* component : {&x_, &y_, &z_}) component->resize(size_t(size));
}

void PointArray::finish() {
  const int padded = (size_ + kLanes - 1) / kLanes * kLanes;
  resize(padded);
  for (std::vector<float>* component : {&x_, &y_, &z_})
    std::fill(component->begin() + size_, component->end(), 0.f);
}

void PointArray::assign(const Eigen::Matrix3Xd& values) {
  clear();
  for (const auto& value : values.colwise()) push_back(value.cast<float>());
  finish();
}

Eigen::Vector3f sum_stokeslets(const PointArray& points, const PointArray& strengths,
                               const Eigen::Vector3f& x0) {
  Eigen::Vector3f sum;
  loops().stokeslets(points.padded_size(), components(points), components(strengths), x0.data(), sum.data());
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
