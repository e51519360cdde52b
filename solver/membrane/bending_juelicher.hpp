#pragma once
#include "solver/membrane/bending.hpp"

namespace capstan {

/// The default model. Forces are the exact negative gradient of the discrete energy of Jülicher (1996),
///   E = E_B/2 sum_i d_i^2 A_i,   d_i = 2H_i - c_i,   2H_i A_i = sum_edges l theta / 2,
/// and therefore include the terms of a spontaneous curvature that varies over the surface.
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
