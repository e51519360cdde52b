#include "solver/case/time_step_defaults.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/limits.hpp"
#include "solver/case/rkc2_steps.hpp"
#include "solver/strain_laws/strain_law.hpp"

namespace capstan {
namespace {

/// Ratio of elastic to viscous forces, for in-plane and for bending deformations.
struct Stiffness {
  double in_plane, bending;
};

/// Stiffness relative to that of a sphere: parts of elongated and flat shapes, and of their meshes, are
/// stiffer.
Stiffness stiffness_of_shape(const Case& c) {
  switch (c.shape) {
    case Shape::sphere:
      return {1, 1};
    case Shape::oblate:
      return {1.2, std::pow(c.aspect, c.has_grid() ? -0.93 : -1.4)};
    case Shape::prolate:
      return {std::pow(std::max(1., c.aspect / 3), c.has_grid() ? 6. : 4.),
              std::pow(std::max(1., c.aspect / 3), c.has_grid() ? 7.5 : 3.)};
    case Shape::biconcave:
      break;
  }
  return {c.has_grid() ? 1.2 : 1, 1.2};
}

Stiffness stiffness_of_membrane(const Case& c) {
  const Stiffness shape = stiffness_of_shape(c);
  const SmallStrainModuli moduli = c.law->moduli(c.law_constants);
  const double in_plane = 0.75 * (moduli.shear + moduli.area);  // 1 for the neo-Hookean law
  return {in_plane / c.Ca * shape.in_plane, c.E_b / c.Ca * shape.bending};
}

}  // namespace

namespace {

/// Of the paper's scheme and of the transient lattice, whose kernel smooths the shortest waves.
double decay_on_smoothing_grid(const Case& c, const Stiffness& membrane) {
  const double dx = c.fidelity.dx, inside = std::max(0., 1 - 1 / c.V);
  return 0.055 * membrane.in_plane / dx + 0.12 * (1 - inside / 2) * membrane.bending / std::pow(dx, 3);
}

/// A contrast of viscosities adds a rate that does not depend on Ca, because the jump moves with the
/// membrane: red cells at V = 10 have rates of up to 27 at Ca = 0.4 and 20 at Ca = 1, where the terms of
/// elasticity are 11 and 4. At Ca = 0.4 steps of 0.047 make Q wrong by 0.012 (kt = 20, dx = 0.2), steps of
/// 0.033 by 0.0006.
double decay_on_sharp_grid(const Case& c, const Stiffness& membrane) {
  const double dx = c.fidelity.dx, mobility = 2 / (1 + std::min(c.V, 10.));  // the outer fluid stays thin
  const double moving_contrast = 1.2 * std::clamp(c.V - 1, 0., 9.);
  return std::hypot(0.3 * std::pow(mobility, c.V > 1 ? 0.5 : 1) * membrane.in_plane / dx,
                    1.3 * std::pow(mobility, c.V > 1 ? 0.1 : 0.5) * membrane.bending / std::pow(dx, 3),
                    moving_contrast);
}

double decay_without_grid(const Case& c, const Stiffness& membrane) {
  const double fineness = c.fidelity.nodes / 642.;
  return 2 / (1 + c.V) *
         (3.4 * membrane.in_plane * std::sqrt(fineness) + 800 * membrane.bending * std::pow(fineness, 1.5));
}

}  // namespace

// A deformation of wavelength l has in-plane forces that scale as 1/l^2 and bending forces that scale as
// 1/l^4; the viscous mobility scales as l. The decay rates therefore scale as 1/l and 1/l^3. The shortest
// wavelength is a few spacings of the grid, which filters shorter ones; without a grid it is the length of an
// edge of the mesh. The factors were measured by power iterations on dU/dX at Ca = 0.1 and kt = 0.1 with 642
// nodes, on the composite grid of dx = 0.2 and without a grid.
// clang-format off
//   sphere                          grid   none   others
//     neo-Hookean                     14     34   dx = 0.1: 31   V = 5, 0.2: 7, 24   none, 2562 nodes: 68
//     Skalak, C = 1                   23
//             C = 10                 123    265   dx = 0.1: 251
//             C = 100               1120   2430
//     E_b = 0.1                      160    830   dx = 0.1: 1370  V = 5, 0.2: 131, 217  2562 nodes: 235, none: 6840
//     E_b = 1                       1600   8340
//   prolate, C = 10, aspect 4, 5     767 (aspect 4)
//            E_b = 0.1, aspect 5    7720   3150
//   oblate,  E_b = 0.1, aspect 0.1  1410  20100
//   red cell (0.25, 4)                14          dx = 0.1: 75
// clang-format on
double fastest_decay(const Case& c) {
  const Stiffness membrane = stiffness_of_membrane(c);
  if (!c.has_grid()) return decay_without_grid(c, membrane);
  const bool smooths = c.fluid == Fluid::transient || c.fidelity.scheme == Scheme::paper;
  return smooths ? decay_on_smoothing_grid(c, membrane) : decay_on_sharp_grid(c, membrane);
}

namespace {

/// AB2 is stable for steps up to 1 / decay rate of the membrane at rest. The factor below 1 is a margin for
/// membranes that become stiffer when stretched, as spheres and spheroids with a strain-hardening law do: at
/// a factor of 0.5 spheres with C = 0.5 to 1 and V <= 1 came out with a D_xy too small by 1 to 4 % (Ca = 0.2
/// to 0.45, dx = 0.2), at 0.42 without error. At 0.35 a step takes one cycle, so that the run is also
/// cheaper. A red cell is hardly stretched, because its area exceeds that of the sphere.
double stable_share(const Case& c) {
  return c.law->is_strain_hardening && c.shape != Shape::biconcave ? 0.35 : 0.5;
}

/// Whether the flow draws out a strain-hardening membrane so far that it becomes many times as stiff as at
/// rest. Red cells (C = 1 to 30, dx = 0.2): steps of half of the stable one at rest, 0.026 to 0.08, diverge
/// at V = 1 and Ca = 4 and at V = 0.1 and Ca = 1 to 4, not at V = 1 and Ca = 1 to 2. Those of 0.02 reach the
/// end at V = 1 and Ca = 4, and rkc2, which measures the stiffness, in eleven of twelve cases.
bool is_drawn_out(const Case& c) {
  return c.has_grid() && c.law->is_strain_hardening && c.Ca >= 2.5 * std::min(1., c.V);
}

double stable_kdt(const Case& c) {
  const double at_rest = stable_share(c) / fastest_decay(c);
  return is_drawn_out(c) ? std::min(at_rest, 0.1 * c.fidelity.dx) : at_rest;
}

/// Accuracy limit of the time step for a grid spacing; the term dx^2 comes from the bending stiffness. The
/// first step is Euler's and changes the volume by 0.2 to 0.3 kdt^2: with this limit by less than 0.1 %.
double resolved_kdt(double dx) { return std::min(0.05, 4 * dx * dx); }

double accurate_kdt(const Case& c) {
  if (!c.has_grid()) return 0.02 * std::min(1., c.Ca * std::pow(642. / c.fidelity.nodes, 1.5));
  if (c.fidelity.scheme == Scheme::paper) return std::min(0.4 * c.Ca, 0.02);  // eq. 43
  return resolved_kdt(c.fidelity.dx);
}

}  // namespace

double default_kdt(const Case& c) {
  const double kdt = std::max(std::min(accurate_kdt(c), stable_kdt(c)), kMinTime);
  return std::round(kdt * 1e9) / 1e9;  // 0.04, not 0.04000000000000001
}

double rkc2_flows(const Case& c) {
  constexpr int kLeastStages = 3;  // steps of two stages are shortened by their error
  const double radius = std::max(1., kRkc2Safety * fastest_decay(c)), step = longest_rkc2_step(radius);
  return std::max(kLeastStages, rkc2_stages(step, radius)) / step;
}

Stepper default_stepper(const Case& c) {
  const bool is_slow = 1 / default_kdt(c) > kRkc2Cost * rkc2_flows(c);
  const bool can_be_slow = c.fidelity.scheme != Scheme::paper || stable_kdt(c) < accurate_kdt(c);
  const bool takes_ab2 = c.has_grid() && !(is_slow && can_be_slow);
  return takes_ab2 ? Stepper::adams_bashforth : Stepper::runge_kutta_chebyshev;
}

double kdt_of_stepper(const Case& c) {
  return c.fidelity.stepper == Stepper::adams_bashforth ? default_kdt(c) : 0;
}

void choose_time_step(Case& c) {
  if (c.fluid == Fluid::quasisteady) c.fidelity.stepper = default_stepper(c);
  c.fidelity.kdt = kdt_of_stepper(c);
}

}  // namespace capstan
