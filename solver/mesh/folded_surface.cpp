#include "solver/mesh/folded_surface.hpp"

#include <cmath>

#include "solver/mesh/geometry.hpp"

namespace capstan {

FoldedSurface::FoldedSurface(const TriangleMesh& mesh, const Points& positions)
    : normals(face_area_vectors(positions, mesh.faces)),
      face_areas(normals.colwise().norm()),
      vertex_areas(Scalars::Zero(positions.cols())),
      lengths(mesh.edges.size()),
      angles(mesh.edges.size()),
      total_curvatures(Scalars::Zero(positions.cols())) {
  for (Eigen::Index face = 0; face < face_areas.size(); ++face) {
    normals.col(face) /= face_areas[face];
    for (int vertex : mesh.faces.col(face)) vertex_areas[vertex] += face_areas[face] / 3;
  }
  for (size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [i, j] = mesh.edges[e].vertices;
    const Vec3 n0 = normals.col(mesh.edges[e].faces[0]), n1 = normals.col(mesh.edges[e].faces[1]);
    const Vec3 along = positions.col(j) - positions.col(i);
    lengths[e] = along.norm();
    angles[e] = std::atan2(n0.cross(n1).dot(along), lengths[e] * n0.dot(n1));
    total_curvatures[i] += lengths[e] * angles[e] / 2;
    total_curvatures[j] += lengths[e] * angles[e] / 2;
  }
  total_curvatures.array() /= vertex_areas.array();
}

}  // namespace capstan
