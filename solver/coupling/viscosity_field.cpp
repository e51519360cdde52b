#include "solver/coupling/viscosity_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/grid/for_each_row.hpp"
#include "solver/mesh/curvature.hpp"
#include "solver/mesh/geometry.hpp"

namespace capstan {

double smoothed_heaviside(double distance_in_cells, double half_width) {
  const double s = distance_in_cells / half_width;
  if (s <= -1) return 0;
  if (s >= 1) return 1;
  return 0.5 * (1 + s + std::sin(std::numbers::pi * s) / std::numbers::pi);
}

ViscosityField::ViscosityField(const GridGeometry& grid, const TriangleMesh& mesh, Orbits orbits,
                               double half_width)
    : grid_(grid),
      half_width_(half_width),
      orbits_(std::move(orbits)),
      patch_(patch_around(orbits_.representatives(), 1, mesh)) {}

// Calls visit(i, y, z, distance, vertex) for each cell of the box: i counts from the start of its row, the
// distance is in cells, and vertex is the nearest one, or kNone far from the membrane.
//
// Only cells in a band around the membrane have a nearest vertex and a distance. A cell beyond the band is
// inside or outside like the last band cell before it in its row; cells before the first band cell are
// outside.
template <class Visit>
void ViscosityField::for_each_cell(const Points& positions, const IndexBox& box, Visit visit) {
  constexpr double kFar = 100;  // cells
  measure_surface(positions);
  nearest_.find((positions.colwise() - grid_.origin) / grid_.dx, reach_, box);
  for_each_row_in_order(box, [&](int y, int z) {
    double beyond = kFar;
    const int* nearest = nearest_.row(y, z);
    for (int i = 0; i < box.size(0); ++i) {
      const int vertex = nearest[i];
      double distance = beyond;
      if (vertex != NearestVertices::kNone) {
        const Vec3 centre = grid_.origin + grid_.dx * Vec3(box.lo[0] + i, y, z);
        distance = signed_distance(centre - positions.col(vertex), vertex) / grid_.dx;
        beyond = distance > 0 ? kFar : -kFar;
      }
      visit(i, y, z, distance, vertex);
    }
  });
}

void ViscosityField::update(const Points& positions, double ambient, double inner, ScalarField& viscosity) {
  for_each_cell(positions, viscosity.box(), [&](int i, int y, int z, double distance, int) {
    viscosity.row(0, y, z)[i] = inner + (ambient - inner) * smoothed_heaviside(distance, half_width_);
  });
}

void ViscosityField::update(const Points& positions, double shift, InterfaceField& interface) {
  for_each_cell(positions, interface.box(), [&](int i, int y, int z, double distance, int vertex) {
    interface.row(kAmbientPartAlong, y, z)[i] = smoothed_heaviside(distance - shift, half_width_);
    interface.row(kAmbientPartOfShear, y, z)[i] = smoothed_heaviside(distance, half_width_);
    const Vec3 normal = vertex == NearestVertices::kNone ? Vec3(Vec3::Zero()) : Vec3(normals_.col(vertex));
    for (int axis = 0; axis < 3; ++axis) interface.row(kMembraneNormal + axis, y, z)[i] = normal[axis];
  });
}

void ViscosityField::measure_surface(const Points& positions) {
  const Points of_patch = patch_.restrict(positions), normals = vertex_normals(of_patch, patch_.mesh.faces);
  const Scalars curvature = mean_curvature(patch_.mesh.faces, of_patch, normals);
  normals_ = orbits_.extend(normals);
  curvature_ = orbits_.extend_scalars(curvature).cwiseMax(-1 / grid_.dx).cwiseMin(1 / grid_.dx);
  reach_ = reach(of_patch);
}

// Distance to the osculating sphere of the vertex, of mean curvature kappa: with r the offset from the
// vertex, p = r.n and t^2 = r^2 - p^2
//   d = (2 p + kappa r^2) / (1 + sqrt((1 + kappa p)^2 + kappa^2 t^2)).
// Differs from the paper: the exact distance to the triangles costs many times as much and gives nearly the
// same smoothed jump. On a crumpled mesh |kappa| is limited to 1/dx, the largest that the grid resolves.
double ViscosityField::signed_distance(const Vec3& offset, int vertex) const {
  const double kappa = curvature_[vertex], p = offset.dot(normals_.col(vertex)), r2 = offset.squaredNorm();
  const double t2 = std::max(0.0, r2 - p * p);
  return (2 * p + kappa * r2) / (1 + std::sqrt(std::pow(1 + kappa * p, 2) + kappa * kappa * t2));
}

/// Distance in cells: every point within two spacings of the surface is within this distance of a vertex. The
/// nearest point on a triangle is at most 0.58 edge lengths from a corner (the centre of an equilateral
/// triangle). The two distances are orthogonal: hypot of the two.
double ViscosityField::reach(const Points& of_patch) const {
  double max_edge2 = 0;
  for (const Edge& edge : patch_.mesh.edges)
    max_edge2 =
        std::max(max_edge2, (of_patch.col(edge.vertices[0]) - of_patch.col(edge.vertices[1])).squaredNorm());
  return std::hypot(2, 0.58 * std::min(std::sqrt(max_edge2) / grid_.dx, 4.0));
}

}  // namespace capstan
