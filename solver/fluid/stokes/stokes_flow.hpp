#pragma once
// Flow without inertia around and inside one capsule in an unbounded shear flow, by boundary integrals
// (Pozrikidis 1992, section 5.3). No grid of the fluid is needed: the velocity u of the membrane obeys an
// equation on the membrane alone,
//   u(x0) = u_shear(x0) + 1/(8 pi) int G(x - x0) f dA + (1 - V)/(8 pi) int [u(x) - u(x0)] T(x - x0) n dA,
// with f the force of the membrane on the fluid per area, V the ratio of inner to outer viscosity, n the
// outward normal, and the Stokeslet G and stresslet T of point_sums.hpp.
#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/stokes/initial_guess.hpp"
#include "solver/fluid/stokes/neighbourhood.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"

namespace capstan {

struct StokesOptions {
  double V = 1;             ///< viscosity ratio
  double volume = 0;        ///< of the capsule / a^3; a deviation from it decays with the rate 10 k
  double tolerance = 1e-4;  ///< relative residual of the equation above
};

class StokesFlow : public FlowModel {
 public:
  /// \param orbits  the symmetry of the capsule: the equation is solved at one vertex of each orbit
  StokesFlow(const TriangleMesh& mesh, Orbits orbits, const StokesOptions& options);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

 private:
  FlowReport solve_integral_equation(const Surface& surface, const std::vector<CloseFace>& close,
                                     const Points& driven, Points& solution);

  TriangleMesh mesh_;
  Orbits orbits_;
  Neighbourhood neighbourhood_;
  StokesOptions options_;
  InitialGuess guess_;
};

}  // namespace capstan
