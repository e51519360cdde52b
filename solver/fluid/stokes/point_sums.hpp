#pragma once
// The sums of the boundary integral method over all pairs of a target and a source: each function computes
// the sum over all sources for one target. With r = x - x0 and the kernels of Pozrikidis (1992):
//   Stokeslet   G_ij = delta_ij / r + r_i r_j / r^3
//   stresslet   T_ijk = -6 r_i r_j r_k / r^5
// A source at the target itself contributes nothing. Sums are in single precision, vectorised; their relative
// error of 1e-6 is below any quadrature error.
#include <Eigen/Core>
#include <vector>

#include "solver/fluid/stokes/point_loops.hpp"

namespace capstan {

/// Points in single precision, one array a component, padded with zeros to whole vectors.
class PointArray {
 public:
  static constexpr int kLanes = 16;

  /// \param values 3 x n
  void assign(const Eigen::Matrix3Xd& values);

  int padded_size() const { return int(x_.size()); }
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }
  const float* z() const { return z_.data(); }

 private:
  std::vector<float> x_, y_, z_;
};

/// sum_n G(x_n - x0) F_n.
/// \param points     x_n
/// \param strengths  F_n
Eigen::Vector3f sum_stokeslets(const PointArray& points, const PointArray& strengths,
                               const Eigen::Vector3f& x0);

/// The same over plain arrays.
/// \param count  number of points, a multiple of PointArray::kLanes
Eigen::Vector3f sum_stokeslets(int count, const Components& points, const Components& strengths,
                               const Eigen::Vector3f& x0);

/// sum_n (u_n - u0)_i T_ijk(x_n - x0) N_k,n.
/// \param points        x_n
/// \param area_vectors  N_n: outward normal times area
/// \param velocities    u_n
Eigen::Vector3f sum_stresslets(const PointArray& points, const PointArray& area_vectors,
                               const PointArray& velocities, const Eigen::Vector3f& x0,
                               const Eigen::Vector3f& u0);

/// Marks the points whose distance to x0 is less than their own reach, and returns the number of marked
/// points.
/// \param reach_squared  of each point, padded with zeros
/// \param marks          result, of each point, padded: 1 within reach, else 0
int mark_within_reach(const PointArray& points, const std::vector<float>& reach_squared,
                      const Eigen::Vector3f& x0, std::vector<unsigned char>& marks);

}  // namespace capstan
