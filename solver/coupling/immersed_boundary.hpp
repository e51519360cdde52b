#pragma once
// The immersed boundary method: forces from the membrane to the grid, velocities from the grid to the
// membrane (paper eqs. 33, 34, 36). The two sums have the same weights and are adjoint to each other.
#include <optional>
#include <vector>

#include "solver/coupling/delta_kernel.hpp"
#include "solver/grid/cell_field.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// A uniform grid in space, in units of a.
struct GridGeometry {
  Vec3 origin;  ///< centre of the cell (0, 0, 0)
  double dx;    ///< spacing
};

/// The cells that kernels with a support of four cells touch around these positions (3 x #V). Nothing if a
/// position is not finite or more than 1e6 cells from the origin, where an index would overflow.
std::optional<IndexBox> cells_around(const Points& positions, const GridGeometry& grid);

class ImmersedBoundary {
 public:
  explicit ImmersedBoundary(const GridGeometry& grid) : grid_(grid) {}

  /// Computes the weights for these positions (3 x #V), and the box of cells in the supports of their delta
  /// functions, with `margin` more cells on every side. Returns false if a position is not finite or more
  /// than 1e6 cells from the origin.
  bool place(const Points& positions, int margin);

  /// The cells that place() found.
  const IndexBox& box() const { return box_; }

  /// field(x) += scale * sum_k forces_k delta(x - X_k). The field must cover box().
  void spread(const Points& forces, double scale, VectorField& field) const;

  /// velocities_k = scale * sum_x field(x) delta(x - X_k). The field must cover box().
  void interpolate(const VectorField& field, double scale, Points& velocities) const;

 private:
  GridGeometry grid_;
  std::vector<Stencil> stencils_;
  IndexBox box_;
};

}  // namespace capstan
