#include "solver/membrane/bending_juelicher.hpp"

#include <cmath>

#include "solver/mesh/geometry.hpp"

namespace capstan {
namespace {

/// Areas, normals and bending of a surface folded along the edges of its triangles.
struct FoldedSurface {
  FoldedSurface(const TriangleMesh& mesh, const Points& positions);

  Points normals;        ///< 3 x #F, unit
  Scalars face_areas;    ///< #F
  Scalars vertex_areas;  ///< #V, A_i
  Scalars lengths;       ///< #E, l
  Scalars angles;        ///< #E, theta
  Scalars curvatures;    ///< #V, 2H_i
};

FoldedSurface::FoldedSurface(const TriangleMesh& mesh, const Points& positions)
    : normals(face_area_vectors(positions, mesh.faces)),
      face_areas(normals.colwise().norm()),
      vertex_areas(Scalars::Zero(positions.cols())),
      lengths(mesh.edges.size()),
      angles(mesh.edges.size()),
      curvatures(Scalars::Zero(positions.cols())) {
  normals.array().rowwise() /= face_areas.transpose().array();
  for (Eigen::Index face = 0; face < face_areas.size(); ++face)
    for (int vertex : mesh.faces.col(face)) vertex_areas[vertex] += face_areas[face] / 3;
  for (size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [i, j] = mesh.edges[e].vertices;
    const auto n0 = normals.col(mesh.edges[e].faces[0]).head<3>(),
               n1 = normals.col(mesh.edges[e].faces[1]).head<3>();
    const Vec3 along = positions.col(j) - positions.col(i);
    lengths[e] = along.norm();
    angles[e] = std::atan2(n0.cross(n1).dot(along) / lengths[e], n0.dot(n1));
    curvatures[i] += lengths[e] * angles[e] / 2;
    curvatures[j] += lengths[e] * angles[e] / 2;
  }
  curvatures.array() /= vertex_areas.array();
}

/// Adds weight * d(area)/dx for one face: half the side opposite to a corner, turned inwards, lifts that
/// corner.
void add_area_gradient(double weight, const Vec3& normal, const Eigen::Vector3i& face, const Points& x,
                       Points& out) {
  for (int corner : {0, 1, 2}) {
    const Vec3 opposite_side = x.col(face[(corner + 2) % 3]) - x.col(face[(corner + 1) % 3]);
    out.col(face[corner]) += 0.5 * weight * normal.cross(opposite_side);
  }
}

/// Adds weight * l d(theta)/dx of the part that face (from, to, tip) has in the angle of its side from -> to.
/// Lifting the tip along the normal by its height over the side unfolds the angle by 1; the ends of the side
/// share the reaction by the law of levers.
void add_angle_gradient(double weight, const Vec3& normal, double area, int from, int to, int tip,
                        const Points& x, Points& out) {
  const Vec3 side = x.col(to) - x.col(from);
  const double cot_from = side.dot(x.col(tip) - x.col(from)) / (2 * area);
  const double cot_to = side.dot(x.col(to) - x.col(tip)) / (2 * area);
  out.col(tip) -= weight * (cot_from + cot_to) * normal;
  out.col(from) += weight * cot_to * normal;
  out.col(to) += weight * cot_from * normal;
}

}  // namespace

Scalars juelicher_curvature(const TriangleMesh& mesh, const Points& positions) {
  return FoldedSurface(mesh, positions).curvatures;
}

// With M_i = 2H_i A_i = sum l theta / 2 the energy is E_B/2 sum (M_i/A_i - c_i)^2 A_i, hence
//   dE = E_B sum_i [ d_i dM_i - d_i (d_i + 2 c_i)/2 dA_i ].
void JuelicherBending::add_forces(const Points& positions, Points& forces) const {
  const FoldedSurface surface(mesh_, positions);
  const Scalars& c = spontaneous_curvature_;
  const Scalars d = surface.curvatures - c;
  const Scalars area_weight = -modulus_ / 6 * d.cwiseProduct(d + 2 * c);
  for (Eigen::Index f = 0; f < mesh_.faces.cols(); ++f) {
    const Eigen::Vector3i face = mesh_.faces.col(f);
    const double weight = area_weight[face[0]] + area_weight[face[1]] + area_weight[face[2]];
    add_area_gradient(-weight, surface.normals.col(f), face, positions, forces);
  }
  for (size_t e = 0; e < mesh_.edges.size(); ++e) {
    const Edge& edge = mesh_.edges[e];
    const auto [i, j] = edge.vertices;
    const double weight = modulus_ * (d[i] + d[j]) / 2;
    const Vec3 stretch =
        weight * surface.angles[e] / surface.lengths[e] * (positions.col(j) - positions.col(i));
    forces.col(i) += stretch;
    forces.col(j) -= stretch;
    for (int side : {0, 1}) {
      const int f = edge.faces[side];
      add_angle_gradient(-weight, surface.normals.col(f), surface.face_areas[f], edge.vertices[side],
                         edge.vertices[1 - side], edge.opposite[side], positions, forces);
    }
  }
}

std::optional<double> JuelicherBending::energy(const Points& positions) const {
  const FoldedSurface surface(mesh_, positions);
  const Scalars d = surface.curvatures - spontaneous_curvature_;
  return modulus_ / 2 * d.cwiseAbs2().dot(surface.vertex_areas);
}

}  // namespace capstan
