#pragma once
// The viscosity around the membrane (paper eqs. 40, 41): the inner one inside, the outer one outside,
// smoothed over two cells on either side.
#include "solver/coupling/immersed_boundary.hpp"
#include "solver/coupling/nearest_vertices.hpp"
#include "solver/grid/cell_box.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"
#include "solver/mesh/surface_patch.hpp"

namespace capstan {

/// Smoothed Heaviside function of the signed distance in cells (eq. 41): 0 below -2, 1 above 2.
double smoothed_heaviside(double distance_in_cells);

class ViscosityField {
 public:
  /// \param orbits of all positions to come
  ViscosityField(const GridGeometry& grid, const TriangleMesh& mesh, Orbits orbits);

  /// viscosity = mu_c + (mu_a - mu_c) H(d) in the cells of the box, which must contain the capsule.
  void update(const Points& positions, double ambient, double inner, ScalarBox& viscosity);

 private:
  void measure_surface(const Points& positions);
  double reach(const Points& of_patch) const;  ///< in cells
  double signed_distance(const Vec3& offset, int vertex) const;

  GridGeometry grid_;
  Orbits orbits_;
  SurfacePatch patch_;  ///< around the representatives
  NearestVertices nearest_;
  Points normals_;     ///< of all vertices
  Scalars curvature_;  ///< likewise
  double reach_ = 0;
};

}  // namespace capstan
