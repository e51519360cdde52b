#pragma once
#include "solver/membrane/bending.hpp"

namespace capstan {

/// The paper's bending force, eq. 31, term by term. The force on the fluid, with kappa = -H and outward
/// normal n, is
///   P = -f_b A_vor,   f_b = E_B [ (2 kappa + c0) (2 kappa^2 - 2 K - c0 kappa) + 2 Delta kappa ] n.
/// H and K come from quadric fits, Delta from the cotangent formula. The force is not the gradient of a
/// discrete energy. If c0 varies over the surface, the terms with Delta c0 and the tangential force are
/// missing, so that the initial shape with c0 "initial" is not in equilibrium. It is kept for comparison with
/// the paper: the motion of a capsule can depend on the difference.
class HelfrichLiteralBending final : public Bending {
 public:
  /// \param spontaneous_curvature #V, c0, the preferred 2H   \param modulus E_B
  HelfrichLiteralBending(const TriangleMesh& mesh, const Scalars& spontaneous_curvature, double modulus)
      : mesh_(mesh), spontaneous_curvature_(spontaneous_curvature), modulus_(modulus) {}

  void add_forces(const Points& positions, Points& forces) const override;
  std::optional<double> energy(const Points&) const override { return std::nullopt; }

 private:
  TriangleMesh mesh_;
  Scalars spontaneous_curvature_;
  double modulus_;
};

}  // namespace capstan
