#pragma once
// Checks that hold for the forces of every membrane law.
#include <random>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan::testing {

/// -dE/dx by central differences, 3 x #V.
/// \param energy  function of the positions
template <class Energy>
Points negative_gradient(const Energy& energy, const Points& positions, double step = 1e-5) {
  Points result(3, positions.cols());
  Points moved = positions;
  for (Eigen::Index i = 0; i < positions.size(); ++i) {
    moved(i) = positions(i) + step;
    const double forward = energy(moved);
    moved(i) = positions(i) - step;
    const double backward = energy(moved);
    moved(i) = positions(i);
    result(i) = (backward - forward) / (2 * step);
  }
  return result;
}

/// Largest absolute difference of two entries over the largest entry of `exact`.
inline double relative_error(const Points& exact, const Points& other) {
  return (exact - other).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
}

inline Vec3 total_force(const Points& forces) { return forces.rowwise().sum(); }

inline Vec3 total_torque(const Points& positions, const Points& forces) {
  Vec3 torque = Vec3::Zero();
  for (Eigen::Index i = 0; i < positions.cols(); ++i) torque += positions.col(i).cross(Vec3(forces.col(i)));
  return torque;
}

/// The positions moved at random by up to `size` in each coordinate; by the same amounts in every call.
inline Points bumped(const Points& positions, double size) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> bump(-size, size);
  return positions + Points::NullaryExpr(3, positions.cols(), [&] { return bump(generator); });
}

inline Eigen::Matrix3d some_rotation() {
  return Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
}

}  // namespace capstan::testing
