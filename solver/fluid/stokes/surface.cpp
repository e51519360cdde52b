#include "solver/fluid/stokes/surface.hpp"

#include "solver/mesh/geometry.hpp"

namespace capstan {

Surface::Surface(const TriangleMesh& mesh_, const Points& positions_)
    : mesh(mesh_),
      positions(positions_),
      face_area_vectors(capstan::face_area_vectors(positions_, mesh_.faces)),
      face_areas(face_area_vectors.colwise().norm()),
      vertex_area_vectors(Points::Zero(3, positions_.cols())),
      vertex_areas(Scalars::Zero(positions_.cols())) {
  for (Eigen::Index face = 0; face < mesh.faces.cols(); ++face) {
    const Vec3 third_of_vector = face_area_vectors.col(face) / 3;
    const double third_of_area = face_areas[face] / 3;
    for (int corner : {0, 1, 2}) {
      const int vertex = mesh.faces(corner, face);
      vertex_area_vectors.col(vertex) += third_of_vector;
      vertex_areas[vertex] += third_of_area;
    }
  }
  points.assign(positions);
}

}  // namespace capstan
