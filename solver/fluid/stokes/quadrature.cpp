#include "solver/fluid/stokes/quadrature.hpp"

#include <algorithm>

namespace capstan {
namespace {

constexpr int kMaxSplits = 3;

/// Appends the rule for one part of the triangle.
/// \param part   3 x 3, barycentric coordinates of the corners of the part
/// \param share  of the area of the triangle
void append_rule(const Eigen::Matrix3d& corners, const Vec3& x0, const Eigen::Matrix3d& part, double share,
                 int splits, std::vector<TrianglePoint>& rule) {
  const Eigen::Matrix3d x = corners * part;
  if (splits == kMaxSplits || TriangleSize(x).can_integrate_from(x0)) {
    for (int n = 0; n < kGaussPoints; ++n) {
      const TrianglePoint point = gauss_point(n);
      rule.push_back({part * point.barycentric, share * point.weight});
    }
    return;
  }
  Eigen::Matrix3d middles;
  for (int c : {0, 1, 2}) middles.col(c) = 0.5 * (part.col((c + 1) % 3) + part.col((c + 2) % 3));
  append_rule(corners, x0, middles, share / 4, splits + 1, rule);
  for (int c : {0, 1, 2}) {
    Eigen::Matrix3d quarter = middles;
    quarter.col(c) = part.col(c);
    append_rule(corners, x0, quarter, share / 4, splits + 1, rule);
  }
}

}  // namespace

TriangleSize::TriangleSize(const Eigen::Matrix3d& x)
    : centre(x.rowwise().mean()),
      max_side2(std::max({(x.col(1) - x.col(0)).squaredNorm(), (x.col(2) - x.col(1)).squaredNorm(),
                          (x.col(0) - x.col(2)).squaredNorm()})) {}

std::vector<TrianglePoint> refined_rule(const Eigen::Matrix3d& corners, const Vec3& x0) {
  std::vector<TrianglePoint> rule;
  append_rule(corners, x0, Eigen::Matrix3d::Identity(), 1, 0, rule);
  return rule;
}

}  // namespace capstan
