#include "solver/fluid/transient/transient_flow.hpp"

#include <cmath>

namespace capstan {
namespace {

Extent extent_of(const Case& c) {
  const int n = int(std::lround(c.fidelity.box / c.fidelity.dx));
  return {n, n, n};
}

LatticeSettings settings_of(const Case& c) {
  const double wall_speed = 0.5 * c.fidelity.box * transient_units(c).velocity_lu;
  return {.rates = kPaperRates, .nu_lu = kTransientViscosity, .wall_speed = wall_speed};
}

}  // namespace

template <class Real>
TransientFlow<Real>::TransientFlow(const Case& c, const TriangleMesh& mesh)
    : kdt_(transient_units(c).kdt),
      lattice_(extent_of(c), settings_of(c)),
      coupling_(c, mesh, transient_units(c)) {
  lattice_.set_couette();
}

template <class Real>
FlowReport TransientFlow<Real>::solve(double, const Points& positions, const Points& forces,
                                      Points& velocities) {
  if (!positions.allFinite() || !forces.allFinite()) return lost_flow(kLostMembrane);
  if (!coupling_.place_membrane(positions, forces)) return lost_flow(kOutsideOfDomain);
  lattice_.set_force(&coupling_.force());
  lattice_.set_viscosity(coupling_.viscosity());
  lattice_.step();
  coupling_.vertex_velocities(lattice_, velocities);
  if (!velocities.allFinite()) return lost_flow("the flow is not finite");
  return {.iterations = 1};
}

template class TransientFlow<float>;
template class TransientFlow<double>;

}  // namespace capstan
