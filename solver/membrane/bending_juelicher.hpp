#pragma once
#include "solver/membrane/bending.hpp"

namespace capstan {

/// Total curvature 2H_i of each vertex from the dihedral angles around it (Jülicher, J. Phys. II 6, 1797,
/// 1996):
///   2H_i = 1/A_i sum_edges l theta / 2
/// l length of an edge at i, theta angle between the normals of its two faces, positive where the surface is
/// convex; A_i a third of the areas of the faces around i.
Scalars juelicher_curvature(const TriangleMesh& mesh, const Points& positions);

/// The default model. Forces are the exact gradient of
///   E = E_B/2 sum_i d_i^2 A_i,   d_i = 2H_i - c_i,
/// so they hold every term of the variation, also those of a spontaneous curvature that differs from place to
/// place. Pointwise the curvature at the 12 vertices with five neighbours is noisy; the energy does not mind.
class JuelicherBending final : public Bending {
 public:
  /// \param spontaneous_curvature #V, c_i   \param modulus E_B
  JuelicherBending(const TriangleMesh& mesh, const Scalars& spontaneous_curvature, double modulus)
      : mesh_(mesh), spontaneous_curvature_(spontaneous_curvature), modulus_(modulus) {}

  void add_forces(const Points& positions, Points& forces) const override;
  std::optional<double> energy(const Points& positions) const override;

 private:
  TriangleMesh mesh_;
  Scalars spontaneous_curvature_;
  double modulus_;
};

}  // namespace capstan
