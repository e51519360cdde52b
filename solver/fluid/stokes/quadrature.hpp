#pragma once
// Quadrature rules for triangles and edges.
#include <array>
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// A quadrature point of a triangle. The weights of a rule sum to 1, so an integral is the weighted sum times
/// the area of the triangle.
struct TrianglePoint {
  Vec3 barycentric;
  double weight;
};

/// The rule of three points, exact for polynomials of degree 2 (Strang and Fix 1973).
inline constexpr int kGaussPoints = 3;
inline TrianglePoint gauss_point(int n) {
  Vec3 barycentric = Vec3::Constant(1. / 6);
  barycentric[n] = 2. / 3;
  return {barycentric, 1. / 3};
}

/// The Gauss-Legendre rule of five points on (0, 1), exact for degree 9.
struct EdgePoint {
  double s, weight;
};
inline constexpr std::array<EdgePoint, 5> kEdgeRule = {{{0.046910077030668, 0.118463442528095},
                                                        {0.230765344947158, 0.239314335249683},
                                                        {0.5, 0.284444444444444},
                                                        {0.769234655052842, 0.239314335249683},
                                                        {0.953089922969332, 0.118463442528095}}};

/// Decides whether the three-point rule is accurate enough for a kernel that is singular at x0. It is if the
/// distance of x0 from the centre of the triangle is at least half the longest side, which is about the
/// distance between the points of the rule.
struct TriangleSize {
  explicit TriangleSize(const Eigen::Matrix3d& corners);
  bool can_integrate_from(const Vec3& x0) const { return (centre - x0).squaredNorm() >= max_side2 / 4; }

  Vec3 centre;
  double max_side2;  ///< longest side, squared
};

/// A rule for a kernel that is singular at x0: the triangle is split into four parts, and these again, until
/// the three-point rule is accurate enough on each part or a part has been split three times.
/// \param corners  3 x 3, one column per corner
std::vector<TrianglePoint> refined_rule(const Eigen::Matrix3d& corners, const Vec3& x0);

}  // namespace capstan
