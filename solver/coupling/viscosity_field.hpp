#pragma once
// The viscosity around the membrane (paper eqs. 40, 41): the inner one inside, the outer one outside,
// smoothed over two cells on either side.
#include "solver/coupling/cell_box.hpp"
#include "solver/coupling/immersed_boundary.hpp"
#include "solver/coupling/nearest_vertices.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// Smoothed Heaviside function of the signed distance in cells (eq. 41): 0 below -2, 1 above 2.
double smoothed_heaviside(double distance_in_cells);

class ViscosityField {
 public:
  ViscosityField(const GridGeometry& grid, const TriangleMesh& mesh) : grid_(grid), mesh_(mesh) {}

  /// viscosity = mu_c + (mu_a - mu_c) H(d) in the cells of the box, which must contain the capsule.
  void update(const Points& positions, double ambient, double inner, ScalarBox& viscosity);

 private:
  double reach(const Points& positions) const;  ///< in cells
  double signed_distance(const Vec3& offset, int vertex) const;

  GridGeometry grid_;
  const TriangleMesh& mesh_;
  NearestVertices nearest_;
  Points normals_;
  Scalars curvature_;
};

}  // namespace capstan
