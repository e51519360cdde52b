// Compiled with -ffast-math: sums may be reordered over the lanes, and 1/sqrt is the hardware's estimate with one Newton
// step. The numbers are the same for any number of threads, and differ in the last bits between kinds of processors.
#include "solver/fluid/stokes/point_sums.hpp"

#include <algorithm>
#include <cmath>

#define CAPSTAN_VECTOR_UNITS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))

namespace capstan {
namespace {

constexpr float kTiny = 1e-12f;  // keeps 1/r finite on the target itself; lost in rounding elsewhere

struct Arrays {
  const float *__restrict x, *__restrict y, *__restrict z;
  explicit Arrays(const PointArray& points) : x(points.x()), y(points.y()), z(points.z()) {}
};

CAPSTAN_VECTOR_UNITS void stokeslets(int count, Arrays at, Arrays force, float x0, float y0, float z0, float* sum) {
  float ux = 0, uy = 0, uz = 0;
  for (int n = 0; n < count; ++n) {
    const float x = at.x[n] - x0, y = at.y[n] - y0, z = at.z[n] - z0;
    const float r2 = x * x + y * y + z * z;
    const float elsewhere = r2 > 0;
    const float inverse = elsewhere / std::sqrt(r2 + kTiny);
    const float along = (x * force.x[n] + y * force.y[n] + z * force.z[n]) * (inverse * inverse);
    ux += inverse * (force.x[n] + along * x);
    uy += inverse * (force.y[n] + along * y);
    uz += inverse * (force.z[n] + along * z);
  }
  sum[0] = ux, sum[1] = uy, sum[2] = uz;
}

CAPSTAN_VECTOR_UNITS void stresslets(int count, Arrays at, Arrays area, Arrays u, float x0, float y0, float z0, float u0,
                                     float v0, float w0, float* sum) {
  float ux = 0, uy = 0, uz = 0;
  for (int n = 0; n < count; ++n) {
    const float x = at.x[n] - x0, y = at.y[n] - y0, z = at.z[n] - z0;
    const float r2 = x * x + y * y + z * z;
    const float inverse = 1 / std::sqrt(r2 + kTiny);
    const float inverse2 = inverse * inverse;
    const float through = (x * area.x[n] + y * area.y[n] + z * area.z[n]) * (inverse2 * inverse2 * inverse);
    const float along = (x * (u.x[n] - u0) + y * (u.y[n] - v0) + z * (u.z[n] - w0)) * through;
    ux += along * x;
    uy += along * y;
    uz += along * z;
  }
  sum[0] = -6 * ux, sum[1] = -6 * uy, sum[2] = -6 * uz;
}

CAPSTAN_VECTOR_UNITS int within_reach(int count, Arrays at, const float* __restrict reach_squared, float x0, float y0,
                                      float z0, unsigned char* __restrict marks) {
  int hits = 0;
  for (int n = 0; n < count; ++n) {
    const float x = at.x[n] - x0, y = at.y[n] - y0, z = at.z[n] - z0;
    marks[n] = x * x + y * y + z * z < reach_squared[n];
    hits += marks[n];
  }
  return hits;
}

}  // namespace

void PointArray::resize(int size) {
  for (std::vector<float>* component : {&x_, &y_, &z_}) component->resize(size_t(size));
}

void PointArray::finish() {
  const int padded = (size_ + kLanes - 1) / kLanes * kLanes;
  resize(padded);
  for (std::vector<float>* component : {&x_, &y_, &z_}) std::fill(component->begin() + size_, component->end(), 0.f);
}

void PointArray::assign(const Eigen::Matrix3Xd& values) {
  clear();
  for (const auto& value : values.colwise()) push_back(value.cast<float>());
  finish();
}

Eigen::Vector3f sum_stokeslets(const PointArray& points, const PointArray& strengths, const Eigen::Vector3f& x0) {
  Eigen::Vector3f sum;
  stokeslets(points.padded_size(), Arrays(points), Arrays(strengths), x0[0], x0[1], x0[2], sum.data());
  return sum;
}

Eigen::Vector3f sum_stresslets(const PointArray& points, const PointArray& area_vectors, const PointArray& velocities,
                               const Eigen::Vector3f& x0, const Eigen::Vector3f& u0) {
  Eigen::Vector3f sum;
  stresslets(points.padded_size(), Arrays(points), Arrays(area_vectors), Arrays(velocities), x0[0], x0[1], x0[2], u0[0],
             u0[1], u0[2], sum.data());
  return sum;
}

int mark_within_reach(const PointArray& points, const std::vector<float>& reach_squared, const Eigen::Vector3f& x0,
                      std::vector<unsigned char>& marks) {
  marks.resize(size_t(points.padded_size()));
  return within_reach(points.padded_size(), Arrays(points), reach_squared.data(), x0[0], x0[1], x0[2], marks.data());
}

}  // namespace capstan
