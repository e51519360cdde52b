#pragma once
// Forces and force dipoles from the membrane to the grid, velocities and velocity gradients from the grid to
// the membrane, by the kernel of spline_kernel.hpp. As in ImmersedBoundary the sums are adjoint to each
// other.
#include <vector>

#include "solver/coupling/immersed_boundary.hpp"
#include "solver/coupling/spline_kernel.hpp"
#include "solver/grid/cell_field.hpp"

namespace capstan {

/// A 3 x 3 tensor at each vertex, row after row: 9 x #V.
using Tensors = Eigen::Matrix<double, 9, Eigen::Dynamic>;

class SplineBoundary {
 public:
  explicit SplineBoundary(const GridGeometry& grid) : grid_(grid) {}

  /// Computes the weights for these positions (3 x #V). Returns false if a position is not finite or more
  /// than 1e6 cells from the origin.
  bool place(const Points& positions);

  /// The cells in the supports of the kernels that place() found.
  const IndexBox& box() const { return box_; }

  /// field_i(x) += scale * sum_k (F_i delta(x - X_k) - T_ij d/dx_j delta(x - X_k)), in lattice units: delta
  /// is the product of the weights.
  ///
  /// \param forces   3 x #V, F
  /// \param dipoles  T in units of F a; no columns if there are none
  void spread(const Points& forces, const Tensors& dipoles, double scale, VectorField& field) const;

  /// velocities_k = sum_x field(x) delta(x - X_k).
  void interpolate(const VectorField& field, Points& velocities) const;

  /// Also the gradients d field_i / d x_j, in units of the field / a.
  void interpolate(const VectorField& field, Points& velocities, Tensors& gradients) const;

 private:
  GridGeometry grid_;
  std::vector<std::array<SplineStencil, 3>> stencils_;
  IndexBox box_;
};

}  // namespace capstan
