#include "solver/fluid/lattice/quasisteady_lbm.hpp"

#include <algorithm>
#include <cmath>

#include "solver/fluid/lattice/fas.hpp"
#include "solver/fluid/lattice/populations_archive.hpp"

namespace capstan {
namespace {

constexpr double kPaperViscosity = 0.04, kPaperGamma = 0.8;

// With a viscosity contrast both sides have to smooth; these keep the contraction below 0.55 for 0.1 <= V
// <= 10.
double tuned_viscosity(double V) { return 0.24 * std::pow(V, -0.35); }
double tuned_gamma(double V) { return V == 1 ? 0.8 : 0.85; }

double viscosity(Scheme scheme, double V) {
  return scheme == Scheme::paper ? kPaperViscosity : tuned_viscosity(V);
}

LatticeUnits units_of(const Case& c) {
  return lattice_units(c.Re, viscosity(c.fidelity.scheme, c.V), c.fidelity.dx);
}

Extent extent_of(const Fidelity& fidelity) {
  const int n = int(std::lround(fidelity.box / fidelity.dx));
  return {n, n, n};
}

}  // namespace

LevelSettings quasisteady_settings(const Case& c) {
  const bool paper = c.fidelity.scheme == Scheme::paper;
  const LatticeUnits units = units_of(c);
  return {.rates = paper ? kPaperRates : kTunedRates,
          .nu_lu = units.nu_lu,
          .wall_speed = 0.5 * c.fidelity.box * units.velocity_lu,
          .inertia = 1,
          .gamma = paper ? kPaperGamma : tuned_gamma(c.V)};
}

QuasisteadyLbm::QuasisteadyLbm(const Case& c, const TriangleMesh& mesh)
    : fidelity_(c.fidelity),
      levels_(make_levels(extent_of(c.fidelity), quasisteady_settings(c))),
      coupling_(c, mesh, units_of(c)),
      last_velocities_(3, mesh.vertex_count()) {
  levels_.front().set_couette();
  if (fidelity_.scheme == Scheme::tuned) previous_ = levels_.front().populations();
}

FlowReport QuasisteadyLbm::solve(double kt, const Points& positions, const Points& forces,
                                 Points& velocities) {
  if (!coupling_.put_membrane(positions, forces, levels_)) return lost_flow(LatticeCoupling::kOutside);
  if (fidelity_.scheme == Scheme::tuned) extrapolate_to(kt);
  return cycle_until_converged(velocities);
}

// Linear in time: what is left for the cycles is the second difference of the flow.
void QuasisteadyLbm::extrapolate_to(double kt) {
  if (!solved_at_.empty() && kt == solved_at_.back()) return;
  const double weight =
      solved_at_.size() < 2 ? 0 : (kt - solved_at_.back()) / (solved_at_.back() - solved_at_.front());
  levels_.front().extrapolate(previous_, weight);
  if (solved_at_.size() == 2) solved_at_.erase(solved_at_.begin());
  solved_at_.push_back(kt);
}

// The change of one cycle is not its error: with contraction rho the cycles to come would add change rho/(1 -
// rho). Differs from the paper, which stops on the change (eq. 26; scheme paper).
FlowReport QuasisteadyLbm::cycle_until_converged(Points& velocities) {
  constexpr int kMostCycles = 400;
  constexpr CycleShape kWCycle{.pre = 1, .post = 1, .visits = 2, .coarsest = 10};
  coupling_.vertex_velocities(levels_.front(), last_velocities_);
  if (fidelity_.scheme == Scheme::paper) last_grid_velocity_ = grid_velocity();
  FlowReport report;
  double last_change = 0;
  while (report.iterations < kMostCycles) {
    fas_cycle(std::span(levels_), kWCycle);
    ++report.iterations;
    coupling_.vertex_velocities(levels_.front(), velocities);
    const double change = relative_change(velocities);
    if (!std::isfinite(change)) return lost_flow("the flow is not finite");
    // the first ratios flatter: smooth errors, which converge last, have not shown yet
    if (last_change > 0) contraction_ = std::clamp(change / last_change, 0.3, 0.95);
    report.error = change * contraction_ / (1 - contraction_);
    last_change = change;
    if ((fidelity_.scheme == Scheme::paper ? change : report.error) <= fidelity_.tolerance) return report;
  }
  report.converged = false;
  report.fault = "the multigrid cycles did not converge";
  return report;
}

/// |u - u_before| / |u|: over all cells for the paper's scheme (eq. 26), at the vertices otherwise.
double QuasisteadyLbm::relative_change(const Points& velocities) {
  if (fidelity_.scheme == Scheme::tuned) {
    const double change = (velocities - last_velocities_).norm() / velocities.norm();
    last_velocities_ = velocities;
    return change;
  }
  VectorBox now = grid_velocity();
  const double change = relative_difference(now, last_grid_velocity_);
  last_grid_velocity_ = std::move(now);
  return change;
}

VectorBox QuasisteadyLbm::grid_velocity() const {
  const auto [nx, ny, nz] = levels_.front().extent();
  VectorBox velocity;
  velocity.reset({0, 0, 0}, {nx, ny, nz});
  levels_.front().velocity(velocity);
  return velocity;
}

void QuasisteadyLbm::save(StateArchive& archive) const {
  put_populations(archive, "fluid/f", levels_.front().populations());
  if (!previous_.empty()) put_populations(archive, "fluid/previous", previous_);
  archive.put("fluid/solved_at", solved_at_);
  archive.put("fluid/contraction", contraction_);
}

void QuasisteadyLbm::load(const StateArchive& archive) {
  get_populations(archive, "fluid/f", levels_.front().populations());
  if (!previous_.empty()) get_populations(archive, "fluid/previous", previous_);
  const auto times = archive.get("fluid/solved_at");
  solved_at_.assign(times.begin(), times.end());
  contraction_ = archive.number("fluid/contraction");
}

}  // namespace capstan
