#pragma once
// The immersed boundary on a grid of which the symmetric capsule needs a quarter: y, z >= 0. Of each orbit of
// vertices one is spread and interpolated, where its image in that quarter stands; what it spreads beyond the
// planes y = 0 and z = 0 comes back as the share of its other images. Without symmetry every vertex is its
// own orbit and the grid is whole.
#include "solver/coupling/immersed_boundary.hpp"
#include "solver/grid/index_box.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"

namespace capstan {

class SymmetricBoundary {
 public:
  SymmetricBoundary(const GridGeometry& grid, Orbits orbits);

  bool has_symmetry() const { return !orbits_.are_trivial(); }

  /// Places the vertices (3 x #V). False when a position is not finite.
  bool place(const Points& positions);

  /// The cells they touch, with `margin` more on every side.
  IndexBox touched(int margin = 0) const;

  /// sum_k scale forces_k delta(x - X_k), in the cells touched.
  void spread(const Points& forces, double scale, VectorBox& box);

  /// velocities_k = sum_x u(x) delta(x - X_k), from the cells touched.
  void interpolate(const VectorBox& box, Points& velocities);

 private:
  Points folded(const Points& of_representatives) const;
  IndexBox extended() const;

  Orbits orbits_;
  ImmersedBoundary boundary_;
  VectorBox extended_box_;  ///< workspace: the cells touched, beyond the planes too
  Points signs_;            ///< 3 x #representatives: +-1, of the symmetry that takes one into the quarter
};

}  // namespace capstan
