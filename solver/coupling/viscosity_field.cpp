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

ViscosityProfile smoothed_jump(double inner, double ambient) {
  return [=](double distance, double) {
    return inner + (ambient - inner) * smoothed_heaviside(distance, kPaperHalfWidth);
  };
}

ViscosityField::ViscosityField(const GridGeometry& grid, const TriangleMesh& mesh, Orbits orbits)
    : grid_(grid), orbits_(std::move(orbits)), patch_(patch_around(orbits_.representatives(), 1, mesh)) {}

// Only cells in a band around the membrane have a nearest vertex and a distance. A cell beyond the band is
// inside or outside like the last band cell before it in its row; cells before the first band cell are
// outside.
void ViscosityField::update(const Points& positions, const ViscosityProfile& profile,
                            ScalarField& viscosity) {
  constexpr double kFar = 100;  // cells
  const double outside = profile(kFar, 0), inside = profile(-kFar, 0);
  const IndexBox& box = viscosity.box();
  measure_surface(positions);
  nearest_.find((positions.colwise() - grid_.origin) / grid_.dx, reach_, box);
  for_each_row_in_order(box, [&](int y, int z) {
    double beyond = outside;
    const int* nearest = nearest_.row(y, z);
    double* row = viscosity.row(0, y, z);
    for (int i = 0; i < box.size(0); ++i) {
      row[i] = beyond;
      if (nearest[i] == NearestVertices::kNone) continue;
      const int vertex = nearest[i];
      const Vec3 centre = grid_.origin + grid_.dx * Vec3(box.lo[0] + i, y, z);
      const double distance = signed_distance(centre - positions.col(vertex), vertex) / grid_.dx;
      row[i] = profile(distance, curvature_[vertex] * grid_.dx);
      beyond = distance > 0 ? outside : inside;
    }
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
