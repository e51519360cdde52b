#include "solver/fluid/lattice/transient_lbm.hpp"

#include <cmath>

#include "solver/fluid/lattice/populations_archive.hpp"

namespace capstan {
namespace {

/// The paper's: at dx = 0.1 a and Re = 0.05 the time step is k dt = 2e-5.
constexpr double kViscosity = 0.04;

LatticeUnits units_of(const Case& c) { return lattice_units(c.Re, kViscosity, c.fidelity.dx); }

Level make_level(const Case& c) {
  const int n = int(std::lround(c.fidelity.box / c.fidelity.dx));
  const double wall_speed = 0.5 * c.fidelity.box * units_of(c).velocity_lu;
  return Level({n, n, n}, {.rates = kPaperRates, .nu_lu = kViscosity, .wall_speed = wall_speed});
}

}  // namespace

TransientLbm::TransientLbm(const Case& c, const TriangleMesh& mesh)
    : kdt_(units_of(c).kdt), level_{make_level(c)}, coupling_(c, mesh, units_of(c)) {
  level_.front().set_couette();
}

FlowReport TransientLbm::solve(double, const Points& positions, const Points& forces, Points& velocities) {
  if (!coupling_.put_membrane(positions, forces, level_)) return lost_flow(LatticeCoupling::kOutside);
  level_.front().step();
  coupling_.vertex_velocities(level_.front(), velocities);
  if (!velocities.allFinite()) return lost_flow("the flow is not finite");
  return {.iterations = 1};
}

void TransientLbm::save(StateArchive& archive) const {
  put_populations(archive, "fluid/f", level_.front().populations());
}

void TransientLbm::load(const StateArchive& archive) {
  get_populations(archive, "fluid/f", level_.front().populations());
}

}  // namespace capstan
