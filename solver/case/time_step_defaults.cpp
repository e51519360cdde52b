#include "solver/case/time_step_defaults.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/limits.hpp"
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
      return {1.2, std::pow(c.aspect, c.has_grid() ? -0.65 : -1.4)};
    case Shape::prolate:
      return {std::pow(std::max(1., c.aspect / 3), 4),
              std::pow(std::max(1., c.aspect / 3), c.has_grid() ? 7. : 3.)};
    case Shape::biconcave:
      break;
  }
  return {1, 1.2};
}

Stiffness stiffness_of_membrane(const Case& c) {
  const Stiffness shape = stiffness_of_shape(c);
  const SmallStrainModuli moduli = c.law->moduli(c.law_constants);
  const double in_plane = 0.75 * (moduli.shear + moduli.area);  // 1 for the neo-Hookean law
  return {in_plane / c.Ca * shape.in_plane, c.E_b / c.Ca * shape.bending};
}

}  // namespace

// A deformation of wavelength l has in-plane forces that scale as 1/l^2 and bending forces that scale as
// 1/l^4; the viscous mobility scales as l. The decay rates therefore scale as 1/l and 1/l^3. The shortest
// wavelength is a few spacings of the grid, which filters shorter ones; without a grid it is the length of an
// edge of the mesh. The factors were measured by the power iteration of rkc2 at Ca = 0.1 and kt = 0.1 with
// 642 nodes, on a grid of dx = 0.2 and without a grid.
// clang-format off
//   sphere                          grid   none   others
//     neo-Hookean                    2.7     34   none, 2562 nodes: 68
//     Skalak, C = 1                  4.2
//             C = 10                  22    265
//             C = 50, 100            116   2430
//     E_b = 0.1                       15    830   dx = 0.1: 121   none, 162 and 2562 nodes: 97, 6840
//     E_b = 1                        153   8340   V = 5: 98
//   prolate, C = 10, aspect 4, 5  54, 162
//            E_b = 0.1, aspect 5     519   3150
//   oblate,  E_b = 0.1, aspect 0.1    65  20100
// clang-format on
double fastest_decay(const Case& c) {
  const Stiffness membrane = stiffness_of_membrane(c);
  if (c.has_grid()) {
    const double dx = c.fidelity.dx, inside = std::max(0., 1 - 1 / c.V);
    return 0.055 * membrane.in_plane / dx + 0.12 * (1 - inside / 2) * membrane.bending / std::pow(dx, 3);
  }
  const double fineness = c.fidelity.nodes / 642.;
  return 2 / (1 + c.V) *
         (3.4 * membrane.in_plane * std::sqrt(fineness) + 800 * membrane.bending * std::pow(fineness, 1.5));
}

namespace {

/// AB2 is stable for steps up to 1 / decay rate. The factor below 1 is a margin for membranes that become
/// stiffer when stretched.
constexpr double kStableShare = 0.65;

double stable_kdt(const Case& c) { return kStableShare / fastest_decay(c); }

/// Accuracy limit of the time step for a grid spacing; the term dx^2 comes from the bending stiffness.
double resolved_kdt(double dx) { return std::min(0.4 * dx, 4 * dx * dx); }

/// The limit 2 Ca dx / area_stiffness is 1/10 of the stability limit of a neo-Hookean sphere, and 1/4 of that
/// of a Skalak sphere with C = 5.
double accurate_kdt(const Case& c) {
  const double dx = c.fidelity.dx,
               area_stiffness = std::max(1.0, 2 * c.law->moduli(c.law_constants).area / 11);
  if (!c.has_grid()) return 0.02 * std::min(1., c.Ca * std::pow(642. / c.fidelity.nodes, 1.5));
  if (c.fidelity.scheme == Scheme::paper) return std::min(0.4 * c.Ca, 0.02);  // eq. 43
  return std::min(resolved_kdt(dx), 2 * c.Ca * dx / area_stiffness);
}

}  // namespace

double default_kdt(const Case& c) {
  const double kdt = std::max(std::min(accurate_kdt(c), stable_kdt(c)), kMinTime);
  return std::round(kdt * 1e9) / 1e9;  // 0.08, not 0.08000000000000002
}

// If the steps of ab2 are shorter than 1/20 of resolved_kdt(), rkc2 needs fewer flow solutions. At 1/16
// (sphere, Ca = 0.0125) both need about the same number.
Stepper default_stepper(const Case& c) {
  constexpr double kSmallShare = 1. / 20;
  const bool is_unstable = stable_kdt(c) < accurate_kdt(c);
  const bool is_slow = default_kdt(c) < kSmallShare * resolved_kdt(c.fidelity.dx);
  const bool takes_ab2 = c.has_grid() && !is_unstable && !is_slow;
  return takes_ab2 ? Stepper::adams_bashforth : Stepper::runge_kutta_chebyshev;
}

}  // namespace capstan
