#include "solver/mesh/surface_quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/mesh/geometry.hpp"

namespace capstan {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// 3 x #F. A face without area has the normal 0, which gives an angle of 90 degrees to its neighbours.
Points unit_normals(const TriangleMesh& mesh, const Points& positions) {
  const Points areas = face_area_vectors(positions, mesh.faces);
  const Eigen::RowVectorXd sizes = areas.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
  return areas.array().rowwise() / sizes.array();
}

double degrees_of_cosine(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) / kDegree; }

/// Cosine of the smallest angle of a triangle, which is opposite to its shortest edge.
double sharpest_corner(const Vec3& a, const Vec3& b, const Vec3& c) {
  std::array<double, 3> squares = {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
  std::ranges::sort(squares);
  const double product = std::sqrt(squares[1] * squares[2]);
  return product > 0 ? (squares[1] + squares[2] - squares[0]) / (2 * product) : 1;
}

}  // namespace

SurfaceQuality surface_quality(const TriangleMesh& mesh, const Points& positions) {
  const Points normals = unit_normals(mesh, positions);
  const double folded_cosine = std::cos(kFoldedEdge * kDegree);
  double smallest_cosine = 1, sharpest = 0.5, longest = 0;
  long folded = 0;
  for (const Edge& edge : mesh.edges) {
    const double cosine = normals.col(edge.faces[0]).dot(normals.col(edge.faces[1]));
    smallest_cosine = std::min(smallest_cosine, cosine);
    folded += cosine < folded_cosine;
    longest = std::max(longest, (positions.col(edge.vertices[1]) - positions.col(edge.vertices[0])).norm());
  }
  for (const auto& face : mesh.faces.colwise())
    sharpest = std::max(
        sharpest, sharpest_corner(positions.col(face[0]), positions.col(face[1]), positions.col(face[2])));
  return {degrees_of_cosine(smallest_cosine), double(folded) / double(mesh.edges.size()),
          degrees_of_cosine(sharpest), longest};
}

SurfaceQuality worst_of(const SurfaceQuality& a, const SurfaceQuality& b) {
  return {std::max(a.largest_dihedral, b.largest_dihedral), std::max(a.folded_edges, b.folded_edges),
          std::min(a.smallest_angle, b.smallest_angle), std::max(a.longest_edge, b.longest_edge)};
}

double smallest_wavelength(const SurfaceQuality& quality) { return 2 * quality.longest_edge; }

}  // namespace capstan
