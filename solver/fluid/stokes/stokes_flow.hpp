#pragma once
// Flow without inertia around and inside one capsule in an unbounded shear flow, by boundary integrals
// (Pozrikidis 1992, section 5.3). At Re -> 0 and far from walls no fluid grid is needed: with the inner
// viscosity V times the outer one the velocity of the membrane obeys, on the membrane alone,
//   u(x0) = u_shear(x0) + 1/(8 pi) int G(x - x0) f dA + (1 - V)/(8 pi) int [u(x) - u(x0)] T(x - x0) n dA.
#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/stokes/neighbourhood.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"

namespace capstan {

class StokesFlow : public FlowModel {
 public:
  struct Options {
    double viscosity_ratio = 1;  ///< V
    double volume = 0;           ///< the capsule's own: a drift from it decays at the rate 10
    double tolerance = 1e-4;     ///< relative residual of the equation above
  };
  /// \param orbits the vertices where the equation is solved, and how they stand for the others
  StokesFlow(const TriangleMesh& mesh, Orbits orbits, const Options& options);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

 private:
  FlowReport solve_for_contrast(const Surface& surface, const std::vector<CloseFace>& close,
                                const Points& driven);

  TriangleMesh mesh_;
  Orbits orbits_;
  Neighbourhood neighbourhood_;
  Options options_;
  Points
      last_;  ///< 3 x #representatives: the last solution, where the next one starts; empty before the first
};

}  // namespace capstan
