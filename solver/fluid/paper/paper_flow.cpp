#include "solver/fluid/paper/paper_flow.hpp"

#include <cmath>
#include <utility>

#include "solver/fluid/lbm/populations_archive.hpp"
#include "solver/grid/full_approximation.hpp"

namespace capstan {
namespace {

constexpr double kViscosity = 0.04, kGamma = 0.8;

LatticeUnits units_of(const Case& c) { return lattice_units(c.Re, kViscosity, c.fidelity.dx); }

std::vector<Level> levels_of(const Case& c) {
  const int n = int(std::lround(c.fidelity.box / c.fidelity.dx));
  return make_levels({n, n, n}, {.rates = kPaperRates,
                                 .nu_lu = kViscosity,
                                 .wall_speed = 0.5 * c.fidelity.box * units_of(c).velocity_lu,
                                 .inertia = 1,
                                 .gamma = kGamma});
}

}  // namespace

PaperFlow::PaperFlow(const Case& c, const TriangleMesh& mesh)
    : tolerance_(c.fidelity.tolerance), levels_(levels_of(c)), coupling_(c, mesh, units_of(c)) {
  levels_.front().set_couette();
}

FlowReport PaperFlow::solve(double, const Points& positions, const Points& forces, Points& velocities) {
  if (!positions.allFinite() || !forces.allFinite()) return lost_flow(kLostMembrane);
  if (!coupling_.put_membrane(positions, forces, levels_)) return lost_flow(kOutsideOfDomain);
  return cycle_until_converged(velocities);
}

// Eq. 26: the change of velocity over a cycle. The error is larger, the more the slower the cycles converge.
FlowReport PaperFlow::cycle_until_converged(Points& velocities) {
  constexpr int kMaxCycles = 400;
  constexpr CycleShape kWCycle{.pre = 1, .post = 1, .visits = 2, .coarsest = 10};
  VectorBox last = grid_velocity();
  FlowReport report;
  while (report.iterations < kMaxCycles) {
    fas_cycle(std::span(levels_), kWCycle);
    ++report.iterations;
    VectorBox now = grid_velocity();
    const double change = relative_difference(now, last);
    last = std::move(now);
    if (!std::isfinite(change)) return lost_flow("the flow is not finite");
    report.error = change;
    if (change > tolerance_) continue;
    coupling_.vertex_velocities(levels_.front(), velocities);
    return report;
  }
  report.converged = false;
  report.fault = "the multigrid cycles did not converge: raise tolerance, or take the fluid stokes";
  return report;
}

VectorBox PaperFlow::grid_velocity() const {
  const auto [nx, ny, nz] = levels_.front().extent();
  VectorBox velocity;
  velocity.reset({0, 0, 0}, {nx, ny, nz});
  levels_.front().velocity(velocity);
  return velocity;
}

void PaperFlow::save(StateArchive& archive) const {
  put_populations(archive, "fluid/f", levels_.front().populations());
}

void PaperFlow::load(const StateArchive& archive) {
  get_populations(archive, "fluid/f", levels_.front().populations());
}

}  // namespace capstan
