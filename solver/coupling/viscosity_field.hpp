#pragma once
// The viscosity around the membrane (paper eqs. 40, 41): the inner one inside, the ambient one outside,
// smoothed over two cells on either side.
#include "solver/coupling/immersed_boundary.hpp"
#include "solver/coupling/nearest_vertices.hpp"
#include "solver/grid/cell_field.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"
#include "solver/mesh/surface_patch.hpp"

namespace capstan {

/// Smoothed Heaviside function of the signed distance in cells (eq. 41): 0 below -2, 1 above 2.
double smoothed_heaviside(double distance_in_cells);

class ViscosityField {
 public:
  /// \param orbits  the symmetry of the surface, which all positions passed to update() must have
  ViscosityField(const GridGeometry& grid, const TriangleMesh& mesh, Orbits orbits);

  /// viscosity = inner + (ambient - inner) H(d / dx) in the cells of the field's box, which must contain the
  /// capsule; d is the signed distance to the membrane, positive outside.
  /// \param positions  3 x #V
  void update(const Points& positions, double ambient, double inner, ScalarField& viscosity);

 private:
  void measure_surface(const Points& positions);
  double reach(const Points& of_patch) const;
  double signed_distance(const Vec3& offset, int vertex) const;

  GridGeometry grid_;
  Orbits orbits_;
  SurfacePatch patch_;  ///< the representatives and their neighbours
  // Scratch of update():
  NearestVertices nearest_;
  Points normals_;     ///< 3 x #V, outward
  Scalars curvature_;  ///< #V, mean curvature, positive on a sphere
  double reach_ = 0;   ///< in cells; cells farther from all vertices are in one fluid
};

}  // namespace capstan
