#include "solver/fluid/transient/transient_flow.hpp"

namespace capstan {

template <class Real>
TransientFlow<Real>::TransientFlow(const TriangleMesh& mesh, const LatticeOptions& options)
    : kdt_(options.units.kdt),
      lattice_(options.cells(),
               {.rates = kPaperRates, .nu_lu = options.units.nu_lu, .wall_speed = options.wall_speed()}),
      coupling_(mesh, options) {
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
