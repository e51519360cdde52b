#pragma once
// The coupling by splines (spline_boundary.hpp, sharpening.hpp) on a quarter of the grid, y, z >= 0, for a
// symmetric capsule (in_plane_symmetry.hpp). Only one vertex of each orbit is used: its image in this quarter
// spreads the force and reads the velocity. The kernel of a vertex near y = 0 or z = 0 extends beyond these
// planes. The forces on cells beyond a plane are added to the images of these cells in the quarter, where
// they equal the forces that the other vertices of the orbit spread there. Without symmetry every vertex is
// its own orbit and the grid covers the whole domain.
#include "solver/coupling/sharpening.hpp"
#include "solver/coupling/spline_boundary.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"

namespace capstan {

class SymmetricBoundary {
 public:
  SymmetricBoundary(const GridGeometry& grid, Orbits orbits);

  bool has_symmetry() const { return !orbits_.are_trivial(); }

  /// Computes the weights for these positions and normals of the membrane (3 x #V). Returns false if a
  /// position is not finite.
  bool place(const Points& positions, const Points& normals);

  /// The cells that sharpened kernels touch; in a quarter, from y = z = 0 on.
  IndexBox touched() const;

  /// field = scale * G [sum_k (F_k delta(x - X_k) - div (S_k n_k + n_k S_k) delta(x - X_k))], in the cells
  /// touched().
  /// \param forces  3 x #V, F
  /// \param dipoles  3 x #V, S in units of F a; no columns if there are none
  void spread(const Points& forces, const Points& dipoles, double scale, VectorField& field);

  /// velocities_k = sum_x (G u)(x) delta(x - X_k), 3 x #V, for a field over touched().
  void interpolate(const VectorField& field, Points& velocities);
  /// Also (grad u + grad u^T) n at the vertices, 3 x #V, read in the same way, for the flow `field` plus (y,
  /// 0, 0).
  void interpolate(const VectorField& field, Points& velocities, Points& shears);

  /// 3 x #V: scale * sum_j vectors_j sum_x delta(x - X_j) delta(x - X_k). Without G.
  Points smoothed(const Points& vectors, double scale);

 private:
  Points folded(const Points& of_representatives) const;
  Points shares(const Points& of_vertices) const;
  IndexBox unfolded() const;
  void fold(VectorField& quarter);
  void unfold(const VectorField& quarter);

  Orbits orbits_;
  SplineBoundary boundary_;
  Sharpening sharpening_;
  Points signs_;    ///< 3 x #representatives: signs (+-1) of the components under the symmetry that maps each
                    ///< one into the quarter
  Points normals_;  ///< 3 x #representatives, in the quarter
  VectorField unfolded_;  ///< scratch: the cells touched, those beyond the planes included
  VectorField quarter_;   ///< scratch of smoothed()
};

}  // namespace capstan
