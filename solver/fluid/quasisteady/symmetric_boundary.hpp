#pragma once
// The immersed boundary method on a quarter of the grid, y, z >= 0, for a symmetric capsule
// (in_plane_symmetry.hpp). Only one vertex of each orbit is used: its image in this quarter spreads the force
// and interpolates the velocity. The delta function of a vertex near y = 0 or z = 0 extends beyond these
// planes. The forces on cells beyond a plane are added to the images of these cells in the quarter, where
// they equal the forces that the other vertices of the orbit spread there. Without symmetry every vertex is
// its own orbit and the grid covers the whole domain.
#include "solver/coupling/immersed_boundary.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"

namespace capstan {

class SymmetricBoundary {
 public:
  SymmetricBoundary(const GridGeometry& grid, Orbits orbits);

  bool has_symmetry() const { return !orbits_.are_trivial(); }

  /// Computes the weights for these positions (3 x #V). Returns false if a position is not finite.
  bool place(const Points& positions);

  /// The cells that the vertices touch, with `margin` more on every side; in a quarter, from y = z = 0 on.
  IndexBox touched(int margin = 0) const;

  /// field(x) = scale * sum_k forces_k delta(x - X_k), in the cells touched().
  void spread(const Points& forces, double scale, VectorField& field);

  /// velocities_k = sum_x field(x) delta(x - X_k). The field covers touched().
  void interpolate(const VectorField& field, Points& velocities);

 private:
  Points folded(const Points& of_representatives) const;
  IndexBox unfolded() const;

  Orbits orbits_;
  ImmersedBoundary boundary_;
  Points signs_;  ///< 3 x #representatives: signs (+-1) of the components under the symmetry that maps each
                  ///< one into the quarter
  VectorField unfolded_;  ///< scratch: the cells touched, those beyond the planes included
};

}  // namespace capstan
