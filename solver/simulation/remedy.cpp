#include "solver/simulation/remedy.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/case_warnings.hpp"
#include "solver/case/choose_fluid.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/case/time_step_defaults.hpp"
#include "solver/strain_laws/strain_law.hpp"

namespace capstan {
namespace {

// Degrees. An oblate capsule of aspect 0.1 has a largest dihedral angle of 53 and a smallest angle of 6.6 at
// rest.
constexpr double kFolded = 90, kCollapsed = 2;

std::string advice_on_fluid(const Case& c) {
  if (!neglects_inertia(c)) return "";
  return "At Re = " + rounded(c.Re) +
         " the quasi-steady flow leaves out what matters: take the fluid unsteady.";
}

/// Whether the time step is too long for the explicit method, judged by the estimated decay rate of the
/// membrane.
bool is_unstable(const Case& c) {
  return c.fluid != Fluid::transient && c.fidelity.kdt * fastest_decay(c) > 0.5;
}

std::string advice_on_time_step(const Case& c) {
  if (c.fluid == Fluid::transient)
    return "The transient flow's time step, 0.04 Re dx^2, may be too long for this membrane: lower Re, E_b "
           "or C, or "
           "raise Ca.";
  if (c.fidelity.stepper != Stepper::adams_bashforth) return "";
  const double shorter = std::min(c.fidelity.kdt / 4, 0.5 / fastest_decay(c));
  const std::string other = c.fluid == Fluid::unsteady ? "" : "the stepper rkc2, or ";
  return "The time step of ab2, kdt = " + rounded(c.fidelity.kdt) +
         ", may be too long for this membrane: take " + other + "a kdt of " + rounded(shorter) + ".";
}

std::string advice_on_folds(const Case& c, const SurfaceQuality& surface) {
  if (!(surface.largest_dihedral > kFolded)) return "";
  constexpr double kEnough = 0.005;  // with this bending stiffness most capsules stay smooth
  const std::string remedy = c.E_b < kEnough ? "raise E_b to " + rounded(kEnough)
                                             : "raise E_b to " + rounded(3 * c.E_b) + ", or take more nodes";
  return "The membrane has folded (" + rounded(std::round(surface.largest_dihedral)) +
         " degrees between two faces), as it does where it is compressed and its bending stiffness is "
         "small: " +
         remedy + ".";
}

std::string advice_on_collapse(const Case& c, const SurfaceQuality& surface) {
  if (c.law->advice_on_collapse)
    if (std::string advice = c.law->advice_on_collapse(c.law_constants); !advice.empty()) return advice;
  if (!(surface.smallest_angle < kCollapsed)) return "";
  return "Triangles of the membrane have collapsed (an angle of " + rounded(surface.smallest_angle) +
         " degrees): raise E_b, lower Ca, or take more nodes.";
}

/// No shape of a membrane that does not harden is steady at a large Ca. With boundary integrals neo-Hookean
/// spheres (V = 1) are drawn out to 3.3 radii at Ca = 1, and to more than 8 at 4.
std::string advice_on_drawn_out_shapes(const Case& c) {
  constexpr double kMaxCa = 1;
  if (c.law->is_strain_hardening || c.Ca <= kMaxCa) return "";
  return "At Ca = " + rounded(c.Ca) + " a capsule of the law " + std::string(c.law->name) +
         " is drawn out without end: lower Ca to " + rounded(kMaxCa) +
         ", or take the law skalak, which hardens.";
}

std::string advice_on_inner_inertia(const Case& c) {
  return "In an inside this thin (V = " + rounded(c.V) + ") inertia is Re/V = " + rounded(c.Re / c.V) +
         " times as large as viscosity, which makes the solution of the flow unstable: lower Re, or raise "
         "V.";
}

/// An inner fluid of low viscosity hardly damps short waves of the membrane. Lattice models smooth these
/// waves.
std::string advice_on_inner_viscosity(const Case& c) {
  if (c.fluid != Fluid::stokes || !(c.V < 0.5)) return "";
  return "An inside this thin (V = " + rounded(c.V) +
         ") hardly damps the membrane: take the fluid quasisteady, raise V, or lower Ca.";
}

}  // namespace

bool is_lost(const SurfaceQuality& surface) {
  return !(surface.largest_dihedral < kFolded && surface.smallest_angle > kCollapsed);
}

std::string remedy(const Case& c, const SurfaceQuality& surface, bool of_motion) {
  const std::string of_fluid = advice_on_fluid(c), of_step = of_motion ? advice_on_time_step(c) : "";
  if (!of_fluid.empty()) return of_fluid;
  if (of_motion && is_too_thin_for_lattice(c)) return advice_on_inner_inertia(c);
  if (of_motion && is_unstable(c)) return of_step;  // folds are a consequence of it
  std::string all;
  for (const std::string& one : {of_step, advice_on_folds(c, surface), advice_on_collapse(c, surface)})
    if (!one.empty()) all += (all.empty() ? "" : " ") + one;
  if (all.empty() && of_motion) all = advice_on_drawn_out_shapes(c);
  if (all.empty() && of_motion) all = advice_on_inner_viscosity(c);
  if (all.empty() && of_motion)
    return "The forces of the membrane are too strong: raise Ca, or lower E_b, C or c0.";
  return all;
}

std::string volume_drift_in_words(double drift) {
  if (!std::isfinite(drift)) return "the volume is not finite";
  if (std::abs(drift) > 10)
    return "the membrane has lost its shape (the volume has drifted by more than 1000 %)";
  return "the volume has drifted by " + std::to_string(std::lround(100 * drift)) + " %";
}

}  // namespace capstan
