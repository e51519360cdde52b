// What a case's scene requires of the solver, and what it does not.
#include "solver/fluid/lattice/quasisteady_lbm.hpp"
#include "solver/fluid/lattice/transient_lbm.hpp"
#include "solver/fluid/stokes/stokes_flow.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/simulation/runge_kutta_chebyshev.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

std::unique_ptr<FlowModel> make_flow(const Case& c, const TriangleMesh& mesh, const Points& initial) {
  switch (c.fluid) {
    case Fluid::transient:
      return std::make_unique<TransientLbm>(c, mesh);
    case Fluid::stokes:
      return std::make_unique<StokesFlow>(
          mesh, Orbits::of(initial),
          StokesFlow::Options{
              .viscosity_ratio = c.V, .volume = volume(initial, mesh.faces), .tolerance = c.fidelity.tolerance});
    case Fluid::quasisteady:
      break;
  }
  return std::make_unique<QuasisteadyLbm>(c, mesh);
}

std::unique_ptr<TimeStepper> make_stepper(const Case& c) {
  if (c.fidelity.stepper == Stepper::runge_kutta_chebyshev) return std::make_unique<RungeKuttaChebyshev>();
  return std::make_unique<AdamsBashforth2>();
}

std::vector<std::string> left_out(const Case& c) {
  std::vector<std::string> parts;
  if (!c.has_viscosity_contrast()) parts.push_back("viscosity field: V = 1");
  if (!c.has_bending()) parts.push_back("bending forces: E_b = 0");
  if (c.fluid == Fluid::quasisteady) parts.push_back("time derivative of the flow: quasi-steady");
  if (c.fluid == Fluid::stokes) {
    parts.push_back("inertia of the fluid: Re = 0");
    parts.push_back("walls: the fluid is unbounded");
  }
  return parts;
}

std::string_view word(Stop stop) {
  switch (stop) {
    case Stop::reached_end:
      return "reached_end";
    case Stop::classified:
      return "classified";
    case Stop::diverged:
      return "diverged";
    case Stop::not_converged:
      return "not_converged";
    case Stop::interrupted:
      break;
  }
  return "interrupted";
}

}  // namespace capstan
