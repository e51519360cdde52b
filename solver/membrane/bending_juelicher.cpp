#include "solver/membrane/bending_juelicher.hpp"

#include "solver/mesh/folded_surface.hpp"

namespace capstan {
namespace {

/// Adds the part of the force -dE/dx that comes from the edge lengths l in M_i = sum l theta / 2 (see
/// add_forces): an edge ij has the tension E_B theta (d_i + d_j)/2.
void add_edge_forces(const TriangleMesh& mesh, const FoldedSurface& surface, const Scalars& d, double modulus,
                     const Points& x, Points& forces) {
  for (size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [i, j] = mesh.edges[e].vertices;
    const double tension = modulus * (d[i] + d[j]) / 2 * surface.angles[e];
    const Vec3 pull = tension / surface.lengths[e] * (x.col(j) - x.col(i));
    forces.col(i) += pull;
    forces.col(j) -= pull;
  }
}

/// Adds the part of the force -dE/dx that comes from the angles theta and the areas A_i. A displacement of a
/// corner along the normal of its face changes the dihedral angles at the three sides of the face. Summed
/// over the faces around a vertex this force is the cotangent formula for -Delta d, weighted with the face
/// normals. The gradient of the area of the face with respect to a corner is half the opposite side, rotated
/// by a right angle in the plane of the face.
/// \param area_weight  #V, dE/dA_i
void add_face_forces(const TriangleMesh& mesh, const FoldedSurface& surface, const Scalars& d,
                     const Scalars& area_weight, double modulus, const Points& x, Points& forces) {
  for (Eigen::Index f = 0; f < mesh.faces.cols(); ++f) {
    const Eigen::Vector3i face = mesh.faces.col(f);
    const Vec3 normal = surface.normals.col(f);
    const double weight = (area_weight[face[0]] + area_weight[face[1]] + area_weight[face[2]]) / 3;
    Eigen::Matrix3d side;  // opposite to each corner
    for (int v : {0, 1, 2}) side.col(v) = x.col(face[(v + 2) % 3]) - x.col(face[(v + 1) % 3]);
    for (int v : {0, 1, 2}) {
      const int a = (v + 1) % 3, b = (v + 2) % 3;
      const double adjacent_a = -side.col(b).dot(side.col(v)), adjacent_b = -side.col(v).dot(side.col(a));
      const double flux = (adjacent_b * (d[face[v]] - d[face[a]]) + adjacent_a * (d[face[v]] - d[face[b]])) /
                          (2 * surface.face_areas[f]);  // cotangent = adjacent / (2 area)
      forces.col(face[v]) -= 0.5 * (modulus * flux * normal + weight * normal.cross(side.col(v)));
    }
  }
}

}  // namespace

// With M_i = 2H_i A_i = sum l theta / 2 the energy is E_B/2 sum (M_i/A_i - c_i)^2 A_i, hence
//   dE = E_B sum_i [ d_i dM_i - d_i (d_i + 2 c_i)/2 dA_i ].
void JuelicherBending::add_forces(const Points& positions, Points& forces) const {
  const FoldedSurface surface(mesh_, positions);
  const Scalars d = surface.total_curvatures - spontaneous_curvature_;
  const Scalars area_weight = -modulus_ / 2 * d.cwiseProduct(d + 2 * spontaneous_curvature_);
  add_edge_forces(mesh_, surface, d, modulus_, positions, forces);
  add_face_forces(mesh_, surface, d, area_weight, modulus_, positions, forces);
}

std::optional<double> JuelicherBending::energy(const Points& positions) const {
  const FoldedSurface surface(mesh_, positions);
  const Scalars d = surface.total_curvatures - spontaneous_curvature_;
  return modulus_ / 2 * d.cwiseAbs2().dot(surface.vertex_areas);
}

}  // namespace capstan
