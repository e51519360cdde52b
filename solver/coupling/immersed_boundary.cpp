#include "solver/coupling/immersed_boundary.hpp"

namespace capstan {

bool ImmersedBoundary::place(const Points& positions, int margin) {
  if (!positions.allFinite()) return false;
  const Vec3 low = (positions.rowwise().minCoeff() - grid_.origin) / grid_.dx;
  const Vec3 high = (positions.rowwise().maxCoeff() - grid_.origin) / grid_.dx;
  constexpr double kFarthestCell = 1e6;  // a position beyond it is lost, and would overflow an index
  if (low.minCoeff() < -kFarthestCell || high.maxCoeff() > kFarthestCell) return false;
  for (int c = 0; c < 3; ++c) {
    lo_[c] = static_cast<int>(std::floor(low[c])) - 1 - margin;
    size_[c] = static_cast<int>(std::floor(high[c])) + 3 + margin - lo_[c];
  }
  stencils_.resize(positions.cols());
  for (Eigen::Index k = 0; k < positions.cols(); ++k)
    for (int c = 0; c < 3; ++c)
      stencils_[k][c] = delta_stencil((positions(c, k) - grid_.origin[c]) / grid_.dx);
  return true;
}

void ImmersedBoundary::spread(const Points& forces, double scale, VectorBox& box) const {
  const int lo_x = box.lo()[0];
  for (std::size_t k = 0; k < stencils_.size(); ++k) {
    const auto& [sx, sy, sz] = stencils_[k];
    for (int c = 0; c < 3; ++c)
      for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 4; ++y) {
          const double share = scale * forces(c, k) * sz.weight[z] * sy.weight[y];
          double* row = box.row(c, sy.first + y, sz.first + z) + (sx.first - lo_x);
          for (int x = 0; x < 4; ++x) row[x] += share * sx.weight[x];
        }
  }
}

void ImmersedBoundary::interpolate(const VectorBox& box, double scale, Points& velocities) const {
  const int lo_x = box.lo()[0];
  for (std::size_t k = 0; k < stencils_.size(); ++k) {
    const auto& [sx, sy, sz] = stencils_[k];
    for (int c = 0; c < 3; ++c) {
      double sum = 0;
      for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 4; ++y) {
          const double* row = box.row(c, sy.first + y, sz.first + z) + (sx.first - lo_x);
          double along = 0;
          for (int x = 0; x < 4; ++x) along += row[x] * sx.weight[x];
          sum += sz.weight[z] * sy.weight[y] * along;
        }
      velocities(c, k) = scale * sum;
    }
  }
}

}  // namespace capstan
