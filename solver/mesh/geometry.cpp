#include "solver/mesh/geometry.hpp"

namespace capstan {
namespace {

/// Signed volume of the tetrahedron (origin, corners of a face), times six.
double six_volumes(const Vec3& x0, const Vec3& x1, const Vec3& x2) { return x0.dot(x1.cross(x2)); }

}  // namespace

Points face_area_vectors(const Points& positions, const Faces& faces) {
  Points area_vectors(3, faces.cols());
  for (Eigen::Index face = 0; face < faces.cols(); ++face) {
    const Vec3 x0 = positions.col(faces(0, face));
    const Vec3 side1 = positions.col(faces(1, face)) - x0;
    const Vec3 side2 = positions.col(faces(2, face)) - x0;
    area_vectors.col(face) = 0.5 * side1.cross(side2);
  }
  return area_vectors;
}

Scalars face_areas(const Points& positions, const Faces& faces) {
  return face_area_vectors(positions, faces).colwise().norm();
}

Scalars vertex_areas(const Points& positions, const Faces& faces) {
  const Scalars of_faces = face_areas(positions, faces);
  Scalars areas = Scalars::Zero(positions.cols());
  for (Eigen::Index face = 0; face < faces.cols(); ++face)
    for (int vertex : faces.col(face)) areas[vertex] += of_faces[face] / 3;
  return areas;
}

Points vertex_area_vectors(const Points& positions, const Faces& faces) {
  const Points of_faces = face_area_vectors(positions, faces);
  Points area_vectors = Points::Zero(3, positions.cols());
  for (Eigen::Index face = 0; face < faces.cols(); ++face)
    for (int vertex : faces.col(face)) area_vectors.col(vertex) += of_faces.col(face) / 3;
  return area_vectors;
}

Points vertex_normals(const Points& positions, const Faces& faces) {
  return vertex_area_vectors(positions, faces).colwise().normalized();
}

double area(const Points& positions, const Faces& faces) { return face_areas(positions, faces).sum(); }

double volume(const Points& positions, const Faces& faces) {
  double six_times = 0;
  for (const auto& face : faces.colwise())
    six_times += six_volumes(positions.col(face[0]), positions.col(face[1]), positions.col(face[2]));
  return six_times / 6;
}

// The divergence theorem, face by face, is a sum over the tetrahedra between the origin and the faces.
Vec3 centroid(const Points& positions, const Faces& faces) {
  Vec3 first_moment = Vec3::Zero();
  for (const auto& face : faces.colwise()) {
    const Vec3 x0 = positions.col(face[0]), x1 = positions.col(face[1]), x2 = positions.col(face[2]);
    first_moment += six_volumes(x0, x1, x2) / 24 * (x0 + x1 + x2);
  }
  return first_moment / volume(positions, faces);
}

// Over a tetrahedron of volume v with corners 0, x0, x1, x2, and s = x0 + x1 + x2:
//   int r r dV = v/20 (x0 x0 + x1 x1 + x2 x2 + s s).
Eigen::Matrix3d second_moments(const Points& positions, const Faces& faces) {
  const Points r = positions.colwise() - centroid(positions, faces);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const auto& face : faces.colwise()) {
    const Vec3 r0 = r.col(face[0]), r1 = r.col(face[1]), r2 = r.col(face[2]);
    const Vec3 sum = r0 + r1 + r2;
    const Eigen::Matrix3d products =
        r0 * r0.transpose() + r1 * r1.transpose() + r2 * r2.transpose() + sum * sum.transpose();
    moments += six_volumes(r0, r1, r2) / 120 * products;
  }
  return moments;
}

Eigen::Matrix3d inertia_tensor(const Points& positions, const Faces& faces) {
  const Eigen::Matrix3d moments = second_moments(positions, faces);
  return moments.trace() * Eigen::Matrix3d::Identity() - moments;
}

}  // namespace capstan
