#pragma once
// Rules for integrals over triangles and edges.
#include <array>
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// A point of a triangle by its barycentric coordinates; weights sum up to 1.
struct TrianglePoint {
  Vec3 barycentric;
  double weight;
};

/// Three points, exact for polynomials of degree 2 (Strang and Fix 1973).
inline constexpr int kGaussPoints = 3;
inline TrianglePoint gauss_point(int n) {
  Vec3 barycentric = Vec3::Constant(1. / 6);
  barycentric[n] = 2. / 3;
  return {barycentric, 1. / 3};
}

/// Gauss-Legendre on (0, 1) with five points, exact for degree 9.
struct EdgePoint {
  double s, weight;
};
inline constexpr std::array<EdgePoint, 5> kEdgeRule = {{{0.046910077030668, 0.118463442528095},
                                                        {0.230765344947158, 0.239314335249683},
                                                        {0.5, 0.284444444444444},
                                                        {0.769234655052842, 0.239314335249683},
                                                        {0.953089922969332, 0.118463442528095}}};

/// A triangle as far as it matters to the three-point rule, which serves for x0 no nearer than half its
/// longest side: that is about the distance between its points.
struct TriangleSize {
  explicit TriangleSize(const Eigen::Matrix3d& corners);
  bool is_served_from(const Vec3& x0) const { return (centre - x0).squaredNorm() >= squared / 4; }

  Vec3 centre;
  double squared;  ///< longest side, squared
};

/// The three-point rule on a triangle split into four again and again, until it serves on every part or a
/// part has been split three times. \param corners 3 x 3, one column a corner
std::vector<TrianglePoint> refined_rule(const Eigen::Matrix3d& corners, const Vec3& x0);

}  // namespace capstan
