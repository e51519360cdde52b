// What a case's scene requires of the solver, and what it does not.
#include "solver/fluid/lattice/quasisteady_lbm.hpp"
#include "solver/fluid/lattice/transient_lbm.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

std::unique_ptr<FlowModel> make_flow(const Case& c, const TriangleMesh& mesh) {
  if (c.fluid == Fluid::transient) return std::make_unique<TransientLbm>(c, mesh);
  return std::make_unique<QuasisteadyLbm>(c, mesh);
}

std::vector<std::string> left_out(const Case& c) {
  std::vector<std::string> parts;
  if (!c.has_viscosity_contrast()) parts.push_back("viscosity field: V = 1");
  if (!c.has_bending()) parts.push_back("bending forces: E_b = 0");
  if (c.fluid == Fluid::quasisteady) parts.push_back("time derivative of the flow: quasi-steady");
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
