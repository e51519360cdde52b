#pragma once
// The viscosity around the membrane (paper eqs. 40, 41): the inner one inside, the ambient one outside,
// smoothed over half a cell to two cells on either side.
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

/// Components of an InterfaceField: the part of a cell that counts as ambient fluid, 0 to 1, for stresses
/// along the membrane (arithmetic mean of the viscosities) and for the shear stress across it (harmonic
/// mean); the normal of the membrane near the cell, or 0 far from the membrane.
enum CellInterface {
  kAmbientPartAlong,
  kAmbientPartOfShear,
  kMembraneNormal,
  kCellInterfaces = kMembraneNormal + 3
};
using InterfaceField = CellField<kCellInterfaces>;

class ViscosityField {
 public:
  /// \param orbits      the symmetry of the surface, which all positions passed to update() must have
  /// \param half_width  of the smoothed jump, in cells, at most 2
  ViscosityField(const GridGeometry& grid, const TriangleMesh& mesh, Orbits orbits, double half_width);

  /// viscosity = inner + (ambient - inner) H(d / dx) in the cells of the field's box, which must contain the
  /// capsule; d is the signed distance to the membrane, positive outside.
  /// \param positions  3 x #V
  void update(const Points& positions, double ambient, double inner, ScalarField& viscosity);

  /// H(d / dx - shift), H(d / dx) and the normals, in the cells of the field's box, which must contain the
  /// capsule.
  /// \param shift  in cells, outwards. |shift| + half_width must be at most 2: farther away no distances are
  ///               computed
  void update(const Points& positions, double shift, InterfaceField& interface);

 private:
  template <class Visit>
  void for_each_cell(const Points& positions, const IndexBox& box, Visit visit);
  void measure_surface(const Points& positions);
  double reach(const Points& of_patch) const;
  double signed_distance(const Vec3& offset, int vertex) const;

  GridGeometry grid_;
  double half_width_;
  Orbits orbits_;
  SurfacePatch patch_;  ///< the representatives and their neighbours
  // Scratch of update():
  NearestVertices nearest_;
  Points normals_;     ///< 3 x #V, outward
  Scalars curvature_;  ///< #V, mean curvature, positive on a sphere
  double reach_ = 0;   ///< in cells; cells farther from all vertices are in one fluid
};

}  // namespace capstan
