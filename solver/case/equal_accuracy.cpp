#include "solver/case/equal_accuracy.hpp"

#include <array>

#include "solver/case/choose_fluid.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/case/time_step_defaults.hpp"

namespace capstan {
namespace {

enum class Coupling { none, second_order, first_order };

Coupling coupling_of(const Case& c) {
  if (!c.has_grid()) return Coupling::none;
  return c.has_composite_grid() ? Coupling::second_order : Coupling::first_order;
}

struct Resolution {
  Coupling coupling;
  double dx;  ///< 0 without a lattice
  int nodes;
  MeasuredError error;
};

constexpr std::string_view kQ = "Q = D_xy (cos 2 theta, sin 2 theta)", kD = "D_xy, relative,";

/// Spheres and red cells to kt = 10 (studies/cross_validation), from coarse to fine. Membranes that wrinkle
/// are not among them.
constexpr auto kResolutions = std::to_array<Resolution>({
    {Coupling::none, 0, 162, {kQ, 0.006, 0.073}},
    {Coupling::none, 0, 642, {kQ, 0.0008, 0.004}},
    {Coupling::none, 0, 2562, {kQ, 0.0002, 0.0004}},
    {Coupling::second_order, 0.4, 162, {kQ, 0.005, 0.27}},
    {Coupling::second_order, 0.2, 642, {kQ, 0.002, 0.035}},
    {Coupling::second_order, 0.1, 2562, {kQ, 0.0006, 0.028}},
    {Coupling::second_order, 0.05, 10242, {kQ, 0.0002, 0.004}},
    {Coupling::first_order, 0.2, 642, {kD, 0.047, 0.1}},
    {Coupling::first_order, 0.1, 2562, {kD, 0.021, 0.035}},
});

/// The last resolution of the table that is not finer than the case; null if there is none.
const Resolution* resolution_of(const Case& c) {
  const Resolution* reached = nullptr;
  for (const Resolution& each : kResolutions)
    if (each.coupling == coupling_of(c) && c.fidelity.nodes >= each.nodes &&
        (!c.has_grid() || c.fidelity.dx <= each.dx))
      reached = &each;
  return reached;
}

/// The coarsest resolution with at most this error, else the finest.
const Resolution& resolution_with_error(Coupling coupling, double error) {
  const Resolution* found = nullptr;
  for (const Resolution& each : kResolutions)
    if (each.coupling == coupling && (!found || found->error.max > error)) found = &each;
  return *found;
}

Case by_boundary_integrals(Case c, const Resolution& resolution) {
  c.fluid = Fluid::stokes;
  c.Re = 0;
  c.fidelity = {.nodes = resolution.nodes, .stepper = Stepper::runge_kutta_chebyshev, .kdt = 0};
  return c;
}

Case on_lattice(Case c, const Resolution& resolution) {
  c.fluid = Fluid::quasisteady;
  c.fidelity = {.dx = resolution.dx, .nodes = resolution.nodes, .tolerance = usual_tolerance(resolution.dx)};
  choose_time_step(c);
  return c;
}

}  // namespace

std::optional<MeasuredError> measured_error(const Case& c) {
  const Resolution* resolution = resolution_of(c);
  return resolution ? std::optional(resolution->error) : std::nullopt;
}

std::string error_in_words(const Case& c) {
  const auto error = measured_error(c);
  if (!error) return "not measured for a mesh or a grid this coarse";
  const std::string range = (error->min > 0 ? rounded(error->min) + " to " : "up to ") + rounded(error->max);
  return std::string(error->quantity) + " is off by " + range +
         " (largest over a run, measured for similar scenes: studies/cross_validation)";
}

std::optional<Case> with_other_fluid(const Case& c) {
  if (c.Re > kMaxStokesRe) return std::nullopt;
  const auto error = measured_error(c);
  const double max = error ? error->max : 1;
  return c.has_grid() ? by_boundary_integrals(c, resolution_with_error(Coupling::none, max))
                      : on_lattice(c, resolution_with_error(Coupling::second_order, max));
}

}  // namespace capstan
