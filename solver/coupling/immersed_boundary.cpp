#include "solver/coupling/immersed_boundary.hpp"

#include "solver/coupling/four_cells.hpp"

namespace capstan {
std::optional<IndexBox> cells_around(const Points& positions, const GridGeometry& grid) {
  if (!positions.allFinite()) return std::nullopt;
  const Vec3 low = (positions.rowwise().minCoeff() - grid.origin) / grid.dx;
  const Vec3 high = (positions.rowwise().maxCoeff() - grid.origin) / grid.dx;
  constexpr double kMaxDistance = 1e6;  // in cells
  if (low.minCoeff() < -kMaxDistance || high.maxCoeff() > kMaxDistance) return std::nullopt;
  IndexBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = static_cast<int>(std::floor(low[axis])) - 1;
    box.hi[axis] = static_cast<int>(std::floor(high[axis])) + 3;
  }
  return box;
}

bool ImmersedBoundary::place(const Points& positions, int margin) {
  const std::optional<IndexBox> cells = cells_around(positions, grid_);
  if (!cells) return false;
  box_ = grown(*cells, margin);
  stencils_.resize(positions.cols());
  for (Eigen::Index k = 0; k < positions.cols(); ++k)
    for (int c = 0; c < 3; ++c)
      stencils_[k][c] = delta_stencil((positions(c, k) - grid_.origin[c]) / grid_.dx);
  return true;
}

void ImmersedBoundary::spread(const Points& forces, double scale, VectorField& field) const {
  for (std::size_t k = 0; k < stencils_.size(); ++k) {
    const Stencil& stencil = stencils_[k];
    spread_vector(weights_of(stencil), scale * forces.col(Eigen::Index(k)), first_cell(field, stencil),
                  field.strides());
  }
}

void ImmersedBoundary::interpolate(const VectorField& field, double scale, Points& velocities) const {
  for (std::size_t k = 0; k < stencils_.size(); ++k) {
    const Stencil& stencil = stencils_[k];
    velocities.col(Eigen::Index(k)) =
        scale * interpolated_vector(weights_of(stencil), first_cell(field, stencil), field.strides());
  }
}

}  // namespace capstan
