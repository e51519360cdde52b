#include "solver/mesh/curvature.hpp"

#include "solver/mesh/geometry.hpp"

namespace capstan {
namespace {

struct Corner {
  Vec3 side1, side2;  ///< from the corner to the next two, counter-clockwise

  Corner(const Points& x, const Eigen::Vector3i& face, int corner)
      : side1(x.col(face[(corner + 1) % 3]) - x.col(face[corner])),
        side2(x.col(face[(corner + 2) % 3]) - x.col(face[corner])) {}

  double dot() const { return side1.dot(side2); }
  double cross() const { return side1.cross(side2).norm(); }
  double cotangent() const { return dot() / cross(); }
};

/// The share of each corner in the area of one face.
Vec3 corner_shares(const Points& x, const Eigen::Vector3i& face) {
  Vec3 squared_opposite, cotangents;
  double area = 0;
  for (int corner : {0, 1, 2}) {
    const Corner here(x, face, corner);
    squared_opposite[corner] = (here.side2 - here.side1).squaredNorm();
    cotangents[corner] = here.cotangent();
    area = here.cross() / 2;
  }
  for (int obtuse : {0, 1, 2})
    if (cotangents[obtuse] < 0) {
      Vec3 shares = Vec3::Constant(area / 4);
      shares[obtuse] = area / 2;
      return shares;
    }
  const Vec3 by_side = squared_opposite.cwiseProduct(cotangents) / 8;
  return Vec3::Constant(by_side.sum()) - by_side;
}

}  // namespace

Scalars mixed_areas(const Points& positions, const Faces& faces) {
  Scalars areas = Scalars::Zero(positions.cols());
  for (const auto& face : faces.colwise()) {
    const Vec3 shares = corner_shares(positions, face);
    for (int corner : {0, 1, 2}) areas[face[corner]] += shares[corner];
  }
  return areas;
}

Scalars cotangent_weights(const TriangleMesh& mesh, const Points& positions) {
  Scalars weights = Scalars::Zero(static_cast<Eigen::Index>(mesh.edges.size()));
  for (size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& [ends, opposite, faces] = mesh.edges[e];
    for (int side : {0, 1}) {
      const Eigen::Vector3i from_opposite(opposite[side], ends[side], ends[1 - side]);
      weights[e] += Corner(positions, from_opposite, 0).cotangent() / 2;
    }
  }
  return weights;
}

Scalars laplace_beltrami(const TriangleMesh& mesh, const Points& positions, const Scalars& values) {
  const Scalars weights = cotangent_weights(mesh, positions);
  Scalars flux = Scalars::Zero(values.size());
  for (size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [i, j] = mesh.edges[e].vertices;
    flux[i] += weights[e] * (values[j] - values[i]);
    flux[j] += weights[e] * (values[i] - values[j]);
  }
  return flux.cwiseQuotient(mixed_areas(positions, mesh.faces));
}

Scalars mean_curvature(const TriangleMesh& mesh, const Points& positions) {
  const Points normals = vertex_normals(positions, mesh.faces);
  Scalars twice = Scalars::Zero(positions.cols());
  for (int axis : {0, 1, 2}) {
    const Scalars laplacian = laplace_beltrami(mesh, positions, positions.row(axis));
    twice -= laplacian.cwiseProduct(normals.row(axis).transpose());
  }
  return twice / 2;
}

}  // namespace capstan
