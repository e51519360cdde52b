#pragma once
// Forces from the membrane to the grid and velocities back (paper eqs. 33, 34, 36): two adjoint sums over the
// same weights.
#include <array>
#include <vector>

#include "solver/coupling/delta_kernel.hpp"
#include "solver/grid/cell_box.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// A uniform grid in space: the centre of cell (0, 0, 0) and the spacing, units of a.
struct GridGeometry {
  Vec3 origin;
  double dx;
};

class ImmersedBoundary {
 public:
  explicit ImmersedBoundary(const GridGeometry& grid) : grid_(grid) {}

  /// Computes the weights for these positions (3 x #V) and the box of cells they touch, with `margin` more
  /// cells on every side. False when a position is not finite.
  bool place(const Points& positions, int margin);

  std::array<int, 3> box_lo() const { return lo_; }
  std::array<int, 3> box_size() const { return size_; }

  /// box += scale * sum_k forces_k delta(x - X_k); the box must cover box_lo(), box_size().
  void spread(const Points& forces, double scale, VectorBox& box) const;

  /// velocities_k = scale * sum_x u(x) delta(x - X_k).
  void interpolate(const VectorBox& box, double scale, Points& velocities) const;

 private:
  GridGeometry grid_;
  std::vector<Stencil> stencils_;
  std::array<int, 3> lo_{}, size_{};
};

}  // namespace capstan
