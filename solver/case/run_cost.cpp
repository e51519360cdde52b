#include "solver/case/run_cost.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/grid_size.hpp"
#include "solver/case/ladder.hpp"
#include "solver/case/time_step_defaults.hpp"
#include "solver/case/units.hpp"

namespace capstan {
namespace {

/// Seconds a step on the composite grid: a constant part and a part proportional to its cells.
double composite_step(const Case& c) {
  constexpr double kFixed = 0.43e-3, kCell = 1.75e-7;
  return (kFixed + kCell * composite_cells(c)) * (c.has_viscosity_ratio() ? 0.8 : 0.55);
}

/// Seconds a step of the paper's scheme: about 35 sweeps over the whole domain.
double papers_step(const Case& c) { return 35 * 25e-9 * uniform_cells(c); }

double transient_run(const Case& c) {
  constexpr double kCell = 9e-9;
  return c.until.kt / transient_units(c).kdt * kCell * uniform_cells(c);
}

/// Additional seconds a vertex for the singular integrals on an elongated or flattened mesh.
double uneven_mesh(const Case& c) {
  constexpr double kDrawnOut = 0.16e-6, kFlattened = 0.1e-6;
  const auto [axis, across] = semi_axes(c);
  return axis > across ? kDrawnOut * std::pow(axis / across - 1, 2) : kFlattened * (across / axis - 1);
}

/// Seconds of a run with boundary integrals: number of steps, times stages per step (more for stiff
/// membranes), times matrix-vector products per flow solution (more for viscosity ratios far from 1). The
/// cost of a product is proportional to the number of pairs of vertices; on coarse meshes the cost per vertex
/// matters, too. Measured at 162 to 10242 nodes, V = 1 and 4, aspects from 0.1 to 5.
double stokes_run(const Case& c) {
  constexpr double kPair = 0.13e-9, kNode = 0.35e-6, kStep = 0.1;
  const double nodes = c.fidelity.nodes, images = c.fidelity.symmetry == Symmetry::automatic ? 1 : 4;
  const double stiffness = 0.0125 * nodes / (c.Ca * (1 + c.V) / 2);
  const double stages = std::sqrt(1 + 1.54 * kStep * stiffness), products = 1 + 3 * std::abs(std::log(c.V));
  const double product = kPair * nodes * nodes + (kNode + uneven_mesh(c)) * nodes;
  return c.until.kt / kStep * stages * products * images * product;
}

double multigrid_run(const Case& c) {
  const double steps_a_unit = c.fidelity.kdt > 0 ? 1 / c.fidelity.kdt : kRkc2Cost * rkc2_flows(c);
  return c.until.kt * steps_a_unit * (c.has_composite_grid() ? composite_step(c) : papers_step(c));
}

double cost_of(const Case& c) {
  switch (c.fluid) {
    case Fluid::stokes:
      return stokes_run(c);
    case Fluid::transient:
      return transient_run(c);
    case Fluid::quasisteady:
    case Fluid::unsteady:
      break;
  }
  return multigrid_run(c);
}

}  // namespace

double run_cost(const Case& c) {
  constexpr double kMin = 1e-4, kMax = 1e10;  // so that sums over a study do not lose small costs to rounding
  return std::clamp(cost_of(c), kMin, kMax);
}

double case_cost(const Case& c) {
  double seconds = 0;
  for (const Case& run : usual_runs(c)) seconds += run_cost(run);
  return seconds;
}

}  // namespace capstan
