#include "solver/case/limits.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/flow_rounding.hpp"
#include "solver/case/grid_size.hpp"
#include "solver/case/run_cost.hpp"
#include "solver/case/run_size.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/case/time_step_defaults.hpp"
#include "solver/case/units.hpp"
#include "solver/strain_laws/strain_law.hpp"

namespace capstan {
namespace {

double transient_steps(const Case& c) {
  return c.fluid == Fluid::transient ? c.until.last() / transient_units(c).kdt : 0;
}

double equal_steps(const Case& c) {
  const bool are_equal = c.fluid != Fluid::transient && c.fidelity.kdt > 0;
  return are_equal ? c.until.last() / c.fidelity.kdt : 0;
}

double records(const Case& c) { return c.until.last() / c.outputs.history_every; }

double shapes(const Case& c) {
  return c.outputs.shapes_every > 0 ? c.until.last() / c.outputs.shapes_every : 0;
}

double gigabytes_of_shapes(const Case& c) { return shapes_size(c) / 1e9; }

double gigabytes_of_grid(const Case& c) { return grid_bytes(c) / 1e9; }

double days(const Case& c) { return case_cost(c) / 86400; }

/// An upper limit of a quantity.
struct Limit {
  std::string_view pointer;         ///< to the parameter that determines the quantity
  double (*quantity)(const Case&);  ///< of a case; 0 if the limit does not concern it
  double max;                       ///< the comment above the row gives the reason
  std::string_view unit, advice;
};

constexpr Limit kLimits[] = {
    // a step takes at least 10 microseconds
    {"/Re", transient_steps, 1e8, "time steps",
     "a step of the transient flow is k dt = 0.04 Re dx^2, so raise Re or dx, lower until.kt, or take the "
     "fluid unsteady, quasisteady or stokes"},
    {"/fidelity/kdt", equal_steps, 1e8, "time steps",
     "raise kdt, lower until.kt, or (except with unsteady) take the stepper rkc2"},
    // a record is a line of history.jsonl and a row of the database
    {"/outputs/history_every", records, 2e5, "records", "raise outputs.history_every or lower until.kt"},
    // a shape is a file, all in one directory
    {"/outputs/shapes_every", shapes, 1e5, "shapes", "raise outputs.shapes_every or lower until.kt"},
    {"/outputs/shapes_every", gigabytes_of_shapes, 50, "GB of shapes on disk",
     "raise outputs.shapes_every, lower until.kt, or take fewer nodes"},
    // the memory of a workstation
    {"/fidelity", gigabytes_of_grid, 16, "GB of memory", "raise dx or lower box"},
    {"/until/kt", days, 366, "days of computing on one core",
     "lower until.kt, or take a coarser fidelity (fewer nodes, a larger dx)"},
};

/// The longest semi-axis of the capsule at rest / a, at the volume of the unit sphere.
double semi_axis_at_rest(const Case& c) {
  constexpr double kBiconcave = 1.53;
  if (c.shape == Shape::biconcave) return kBiconcave;
  const auto [axis, across] = semi_axes(c);
  return std::max(axis, across);
}

/// Lower bound of the longest semi-axis of a deformed sphere over its radius. Measured with boundary
/// integrals for the neo-Hookean law: 1.4, 2.3, 3.3 and more than 8 at Ca = 0.1, 0.5, 1 and 4 with V = 1,
/// and 1.8 at Ca = 1 with V = 5. Strain-hardening laws stay near 1.
double elongation(const Case& c) {
  if (c.law->is_strain_hardening) return 1;
  return 1 + std::min(2 * c.Ca * 2 / (1 + std::max(1., c.V)), 0.5 * c.until.kt);
}

/// Below this the velocities in lattice units are lost in rounding errors.
constexpr double kMinReynolds = 1e-6;

void check_precision(const Case& c, Issues& issues) {
  const double min_tolerance = flow_rounding(c);
  if (!c.solves_for_flow() || c.fidelity.tolerance >= min_tolerance) return;
  issues.push_back({"/fidelity/tolerance", "is " + rounded(c.fidelity.tolerance) +
                                               ", and the flow in single precision is known to " +
                                               rounded(min_tolerance) + " at best: raise it" +
                                               (c.has_precision() ? ", or take precision double" : "")});
}

/// The membrane moves with the time step of the lattice. Its stability limits the decay rate of the
/// membrane's fastest mode times the step: a sphere at Re = 10 and dx = 0.2 kept its volume at 4, not at 10.
/// The stability of the lattice Boltzmann method limits the velocity of the walls in lattice units: 0.2 was
/// stable, 0.26 was not.
void check_transient(const Case& c, Issues& issues) {
  constexpr double kMinStep = 1e-8, kMaxDecay = 6, kMaxWallSpeed = 0.22;
  const LatticeUnits units = transient_units(c);
  const double decay = units.kdt * fastest_decay(c), wall_speed = 0.5 * c.fidelity.box * units.velocity_lu;
  if (units.kdt < kMinStep)
    issues.push_back({"/Re", "makes a time step of " + rounded(units.kdt) + ", and times are resolved to " +
                                 rounded(kMinStep) + " at best: raise Re or dx (the step is 0.04 Re dx^2)"});
  if (wall_speed > kMaxWallSpeed)
    issues.push_back({"/Re", "makes the walls move by " + rounded(wall_speed) +
                                 " cells a time step (0.02 Re dx box), and the lattice is stable to " +
                                 rounded(kMaxWallSpeed) + ": lower Re, dx or box"});
  if (decay > kMaxDecay)
    issues.push_back({"/Ca", "makes a membrane so stiff that its fastest motion decays " + rounded(decay) +
                                 " times in a step of the transient flow (0.04 Re dx^2), and " +
                                 rounded(kMaxDecay) +
                                 " times are stable: raise Ca, lower E_b, C or Re, or take another fluid"});
}

void check_grid_fits(const Case& c, Issues& issues) {
  if (c.needs_inertia() && c.Re < kMinReynolds)
    issues.push_back(
        {"/Re", "is " + rounded(c.Re) + ", and this flow model needs at least " + rounded(kMinReynolds) +
                    ": raise it, or take the fluid quasisteady or stokes, which can do without inertia"});
  if (c.fidelity.box < min_box(c))
    issues.push_back({"/fidelity/box",
                      "is " + rounded(c.fidelity.box) + ", and the capsule, drawn out to a length of " +
                          rounded(2 * semi_axis_at_rest(c) * elongation(c)) + ", needs at least " +
                          rounded(min_box(c)) + ": take a larger box, or the fluid stokes, which has none"});
}

}  // namespace

double min_box(const Case& c) {
  constexpr double kCells = 4;
  return 2 * (semi_axis_at_rest(c) * elongation(c) + kCells * c.fidelity.dx);
}

double grid_bytes(const Case& c) {
  // bytes a cell: populations before and after a sweep, and relaxation rates; on coarse levels, which
  // together have 1/7 of the cells, also the right-hand side D and the start I f. kInPlace: only one set of
  // populations, in single precision.
  constexpr double kPaper = 19 * 8 * 2 + 8 + 19 * 8 * 4 / 7., kInPlace = 19 * 4;
  const double cells = uniform_cells(c);
  if (c.fluid == Fluid::transient)
    return cells * kInPlace * (c.fidelity.precision == Precision::double_ ? 2 : 1);
  return c.fluid == Fluid::quasisteady && c.fidelity.scheme == Scheme::paper ? cells * kPaper : 0;
}

Issues limits_exceeded(const Case& c) {
  Issues issues;
  for (const Limit& limit : kLimits)
    if (const double quantity = limit.quantity(c); !(quantity <= limit.max))
      issues.push_back({std::string(limit.pointer), "makes a run of " + rounded(quantity) + " " +
                                                        std::string(limit.unit) + ", and at most " +
                                                        rounded(limit.max) +
                                                        " are possible: " + std::string(limit.advice)});
  if (c.fluid == Fluid::transient) check_transient(c, issues);
  if (c.has_grid()) check_grid_fits(c, issues);
  check_precision(c, issues);
  return issues;
}

}  // namespace capstan
