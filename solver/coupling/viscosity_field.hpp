#pragma once
// The viscosity around the membrane, a function of the distance to it.
#include <functional>

#include "solver/coupling/immersed_boundary.hpp"
#include "solver/coupling/nearest_vertices.hpp"
#include "solver/grid/cell_field.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"
#include "solver/mesh/surface_patch.hpp"

namespace capstan {

/// Cells on either side of the membrane over which the paper smooths the jump.
inline constexpr double kPaperHalfWidth = 2;

/// Smoothed Heaviside function of the signed distance in cells (eq. 41): 0 below -half_width, 1 above.
double smoothed_heaviside(double distance_in_cells, double half_width);

/// A viscosity as a function of the signed distance to the membrane in cells, positive outside, and of its
/// mean curvature in 1/cells, positive on a sphere.
using ViscosityProfile = std::function<double(double distance, double curvature)>;

/// The paper's profile (eqs. 40, 41): inner + (ambient - inner) H(d), smoothed over two cells on either side.
ViscosityProfile smoothed_jump(double inner, double ambient);

class ViscosityField {
 public:
  /// \param orbits  the symmetry of the surface, which all positions passed to update() must have
  ViscosityField(const GridGeometry& grid, const TriangleMesh& mesh, Orbits orbits);

  /// viscosity = profile(d / dx, kappa dx) in the cells of the field's box, which must contain the capsule; d
  /// is the signed distance to the membrane. Farther than two cells from it the profile must be constant.
  /// \param positions  3 x #V
  void update(const Points& positions, const ViscosityProfile& profile, ScalarField& viscosity);

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
