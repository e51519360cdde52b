#include "solver/case/run_cost.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/units.hpp"

namespace capstan {
namespace {

double uniform_cells(const Case& c) { return std::pow(c.fidelity.box / c.fidelity.dx, 3); }

/// A step on the composite of grids: the box around the capsule, its margins, and what does not depend on the
/// spacing.
double composite_step(const Case& c) {
  constexpr double kFixed = 0.43e-3, kCell = 1.75e-7;
  constexpr double kExtent = 2.6, kMargins = 12;  // of the finest box / a, in cells
  const double cells = std::pow(kExtent / c.fidelity.dx + kMargins, 3);
  const double share = c.fidelity.symmetry == Symmetry::automatic ? 0.25 : 1;
  return (kFixed + kCell * share * cells) * (c.has_viscosity_contrast() ? 1 : 0.55);
}

/// The paper's scheme takes some thirty-five sweeps over the whole domain a step.
double papers_step(const Case& c) { return 35 * 25e-9 * uniform_cells(c); }

double transient_run(const Case& c) {
  constexpr double kCell = 9e-9, kNu = 0.04;
  return c.until.kt / lattice_units(c.Re, kNu, c.fidelity.dx).kdt * kCell * uniform_cells(c);
}

/// Sums over all pairs of vertices: stages of the stepper, which stiff membranes ask for, times the products
/// of one solve, of which unequal viscosities need more.
double stokes_run(const Case& c) {
  constexpr double kPair = 0.17e-9, kStep = 0.1;
  const double nodes = c.fidelity.nodes, images = c.fidelity.symmetry == Symmetry::automatic ? 1 : 4;
  const double stiffness = 0.05 * nodes / (c.Ca * (1 + c.V) / 2);
  const double stages = std::sqrt(1 + 1.54 * kStep * stiffness), products = 2 + 3 * std::abs(std::log(c.V));
  return c.until.kt / kStep * stages * products * kPair * images * nodes * nodes;
}

double quasisteady_run(const Case& c) {
  constexpr double kChosenStep = 0.02;  // where the stepper chooses: of one solve
  const double steps = c.until.kt / (c.fidelity.kdt > 0 ? c.fidelity.kdt : kChosenStep);
  return steps * (c.has_composite_grid() ? composite_step(c) : papers_step(c));
}

double cost_of(const Case& c) {
  switch (c.fluid) {
    case Fluid::stokes:
      return stokes_run(c);
    case Fluid::transient:
      return transient_run(c);
    case Fluid::quasisteady:
      break;
  }
  return quasisteady_run(c);
}

}  // namespace

double run_cost(const Case& c) {
  constexpr double kLeast = 1e-4, kMost = 1e10;  // beyond, sums over a study would lose the others
  return std::clamp(cost_of(c), kLeast, kMost);
}

}  // namespace capstan
