#include "solver/coupling/viscosity_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/mesh/curvature.hpp"
#include "solver/mesh/geometry.hpp"

namespace capstan {

double smoothed_heaviside(double distance_in_cells) {
  const double s = std::clamp(distance_in_cells / 2, -1.0, 1.0);
  return 0.5 * (1 + s + std::sin(std::numbers::pi * s) / std::numbers::pi);
}

// Along a row of cells the band of known distances is met before the other side is, so a cell beyond the band
// is on the side of the last cell that was in it.
void ViscosityField::update(const Points& positions, double ambient, double inner, ScalarBox& viscosity) {
  normals_ = vertex_normals(positions, mesh_.faces);
  curvature_ = mean_curvature(mesh_.faces, positions, normals_).cwiseMax(-1 / grid_.dx).cwiseMin(1 / grid_.dx);
  find_nearest_vertices(positions, viscosity);
  std::size_t cell = 0;
  viscosity.for_each_row([&](int y, int z) {
    double outside = 1;
    for (int i = 0; i < viscosity.size()[0]; ++i, ++cell) {
      const int vertex = nearest_[cell];
      double H = outside;
      if (vertex >= 0) {
        const Vec3 centre = grid_.origin + grid_.dx * Vec3(viscosity.lo()[0] + i, y, z);
        const double distance = signed_distance(centre - positions.col(vertex), vertex);
        H = smoothed_heaviside(distance / grid_.dx);
        outside = distance > 0 ? 1 : 0;
      }
      viscosity.row(0, y, z)[i] = inner + (ambient - inner) * H;
    }
  });
}

// The surface near a vertex is its osculating sphere of curvature kappa: with r the offset, p = r.n and t^2 =
// r^2 - p^2
//   d = (2 p + kappa r^2) / (1 + sqrt((1 + kappa p)^2 + kappa^2 t^2)).
// Differs from the paper: the exact distance to the triangles costs many times as much and smooths the same
// jump. Where the mesh crumples, curvature is bounded by what the grid can tell.
double ViscosityField::signed_distance(const Vec3& offset, int vertex) const {
  const double kappa = curvature_[vertex], p = offset.dot(normals_.col(vertex)), r2 = offset.squaredNorm();
  const double t2 = std::max(0.0, r2 - p * p);
  return (2 * p + kappa * r2) / (1 + std::sqrt(std::pow(1 + kappa * p, 2) + kappa * kappa * t2));
}

void ViscosityField::find_nearest_vertices(const Points& positions, const ScalarBox& box) {
  double longest2 = 0;
  for (const Edge& edge : mesh_.edges)
    longest2 =
        std::max(longest2, (positions.col(edge.vertices[0]) - positions.col(edge.vertices[1])).squaredNorm());
  // a cell within two spacings of the surface is within this of a vertex (0.58: centre of an equilateral
  // triangle)
  const double reach = 2 * grid_.dx + 0.58 * std::min(std::sqrt(longest2), 4 * grid_.dx);
  distance2_.reset(box.lo(), box.size(), reach * reach);
  const auto [nx, ny, nz] = box.size();
  nearest_.assign(std::size_t(nx) * ny * nz, -1);
  for (Eigen::Index k = 0; k < positions.cols(); ++k) {
    const Vec3 at = (positions.col(k) - grid_.origin) / grid_.dx;
    std::array<int, 3> first{}, last{};
    for (int c = 0; c < 3; ++c) {
      first[c] = std::max(box.lo()[c], int(std::ceil(at[c] - reach / grid_.dx)));
      last[c] = std::min(box.lo()[c] + box.size()[c] - 1, int(std::floor(at[c] + reach / grid_.dx)));
    }
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y) {
        const double yz2 = std::pow(y - at[1], 2) + std::pow(z - at[2], 2);
        double* row = distance2_.row(0, y, z) - box.lo()[0];
        int* nearest = &nearest_[(std::size_t(z - box.lo()[2]) * ny + (y - box.lo()[1])) * nx] - box.lo()[0];
        for (int x = first[0]; x <= last[0]; ++x) {
          const double d2 = (yz2 + (x - at[0]) * (x - at[0])) * grid_.dx * grid_.dx;
          if (d2 < row[x]) row[x] = d2, nearest[x] = static_cast<int>(k);
        }
      }
  }
}

}  // namespace capstan
