#include "solver/case/left_out.hpp"

#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

std::string time_derivative(const Case& c) {
  constexpr double kErrorPerRe = 0.07;
  return "time derivative of the flow: quasi-steady; Q = D_xy (cos 2 theta, sin 2 theta) is wrong by about "
         "0.07 Re = " +
         rounded(kErrorPerRe * c.Re, 2) + " (studies/fig10)";
}

bool is_a_quarter(const Case& c) {
  return c.can_use_symmetry() && c.fidelity.symmetry == Symmetry::automatic;
}

}  // namespace

std::vector<std::string> left_out(const Case& c) {
  std::vector<std::string> parts;
  if (!c.has_viscosity_ratio()) parts.emplace_back("viscosity field: V = 1; this changes nothing");
  if (!c.has_bending())
    parts.emplace_back("bending forces: E_b = 0; nothing resists folding where the membrane is compressed");
  if (c.shape != Shape::sphere)
    parts.emplace_back(
        "motion out of the plane of shear: the capsule starts in this plane; a tilted start is not followed, "
        "and near the boundary between tumbling and tank-treading it can change the label (README.md, "
        "Limits)");
  if (c.fluid == Fluid::quasisteady && c.Re > 0) parts.push_back(time_derivative(c));
  if (is_a_quarter(c))
    parts.emplace_back(
        "three quarters of the flow: images of the fourth by the symmetry of the plane of shear; this "
        "changes "
        "nothing but rounding errors");
  if (c.has_composite_grid())
    parts.emplace_back(
        "fine grid far from the capsule: coarser grids there change D_xy by less than 0.0005 "
        "(studies/README.md)");
  if (c.Re == 0)
    parts.emplace_back(
        "inertia of the fluid: Re = 0; Re = 0.05 adds 0.5 % to the D_xy of a sphere "
        "(studies/cross_validation)");
  if (c.fluid == Fluid::stokes)
    parts.emplace_back(
        "walls: the fluid is unbounded; walls 25.6 apart change Q by 0.0003 to 0.004 "
        "(studies/cross_validation)");
  return parts;
}

}  // namespace capstan
