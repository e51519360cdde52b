#include "solver/fluid/paper/paper_flow.hpp"

#include <cmath>
#include <utility>

#include "solver/fluid/paper/populations_archive.hpp"
#include "solver/grid/full_approximation.hpp"

namespace capstan {
namespace {

constexpr double kViscosity = 0.04;  // lattice units: that of the paper's transient method
constexpr double kGamma = 0.8;

LatticeOptions lattice_of(const PaperOptions& options) {
  return {.units = lattice_units(options.Re, kViscosity, options.dx), .box = options.box, .V = options.V};
}

std::vector<PopulationGrid> make_grids(const LatticeOptions& lattice) {
  return make_population_grids(lattice.cells(), {.rates = kPaperRates,
                                                 .nu_lu = kViscosity,
                                                 .wall_speed = lattice.wall_speed(),
                                                 .inertia = 1,
                                                 .gamma = kGamma});
}

}  // namespace

PaperFlow::PaperFlow(const TriangleMesh& mesh, const PaperOptions& options)
    : tolerance_(options.tolerance),
      grids_(make_grids(lattice_of(options))),
      coupling_(mesh, lattice_of(options)) {
  grids_.front().set_couette();
}

FlowReport PaperFlow::solve(double, const Points& positions, const Points& forces, Points& velocities) {
  if (!positions.allFinite() || !forces.allFinite()) return lost_flow(kLostMembrane);
  if (!coupling_.place_membrane(positions, forces)) return lost_flow(kOutsideOfDomain);
  grids_.front().set_force(&coupling_.force());
  if (coupling_.viscosity()) put_viscosity(*coupling_.viscosity());
  return cycle_until_converged(velocities);
}

void PaperFlow::put_viscosity(ScalarField nu_lu) {
  for (PopulationGrid& grid : grids_) {
    grid.set_viscosity(nu_lu);
    nu_lu = coarsened(nu_lu, kViscosity);
  }
}

// The error is estimated by the change of the velocity in a cycle (eq. 26). The true error is larger than
// this change if the cycles converge slowly.
FlowReport PaperFlow::cycle_until_converged(Points& velocities) {
  constexpr int kMaxCycles = 400;
  constexpr CycleShape kWCycle{.pre = 1, .post = 1, .visits = 2, .coarsest = 10};
  VectorField last = grid_velocity();
  FlowReport report;
  while (report.iterations < kMaxCycles) {
    fas_cycle(std::span(grids_), kWCycle);
    ++report.iterations;
    VectorField now = grid_velocity();
    const double change = relative_difference(now, last);
    last = std::move(now);
    if (!std::isfinite(change)) return lost_flow("the flow is not finite");
    report.error = change;
    if (change > tolerance_) continue;
    coupling_.vertex_velocities(grids_.front(), velocities);
    return report;
  }
  report.converged = false;
  report.reason = "the multigrid cycles did not converge: raise tolerance, or take the fluid stokes";
  return report;
}

VectorField PaperFlow::grid_velocity() const {
  VectorField velocity;
  velocity.reset(grids_.front().box());
  grids_.front().velocity(velocity);
  return velocity;
}

void PaperFlow::save(StateArchive& archive) const {
  put_populations(archive, "fluid/f", grids_.front().populations());
}

void PaperFlow::load(const StateArchive& archive) {
  get_populations(archive, "fluid/f", grids_.front().populations());
}

}  // namespace capstan
