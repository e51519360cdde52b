#include "solver/case/case_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/case/choose_fluid.hpp"
#include "solver/case/grid_size.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/case/wrinkling.hpp"

namespace capstan {
namespace {

/// Warns if the flow model neglects inertia at a Reynolds number above the limit of the paper, fig. 10.
std::string neglected_inertia(const Case& c) {
  if (!neglects_inertia(c)) return "";
  return "Re = " + rounded(c.Re) +
         ": the quasi-steady flow neglects the time derivative, which matters from Re = 0.1 on; use "
         "\"fluid\": \"unsteady\"";
}

/// Edge length / a of equilateral triangles that cover the unit sphere.
double mean_edge(int nodes) {
  const double faces = 2. * (nodes - 2);
  return std::sqrt(4 * std::numbers::pi / faces * 4 / std::sqrt(3.));
}

/// Measured with 162 and 642 nodes at kt = 3: edges of 1.5 dx are good. With edges of 3 dx fluid passes
/// between the vertices, the volume changes by 0.6 to 3.6 %, and the error of D is larger than with twice the
/// spacing.
std::string lattice_finer_than_mesh(const Case& c) {
  constexpr double kMaxEdge = 2;  // dx
  const double edge = mean_edge(c.fidelity.nodes);
  if (!c.has_grid() || edge <= kMaxEdge * c.fidelity.dx) return "";
  return "the lattice is finer than the membrane's mesh: dx = " + rounded(c.fidelity.dx) +
         ", but the edges of " + std::to_string(c.fidelity.nodes) + " nodes are " + rounded(edge) +
         " long, so that fluid passes between the vertices; use more nodes, or dx of at least " +
         rounded(edge / kMaxEdge);
}

/// By which share D of a round capsule comes out too large. Measured for spheres, Ca = 0.05 and 0.2, kt = 6.
/// Where the jump of the viscosity is smoothed over four cells: 8 % at V = 5 and 18 % at V = 10, dx = 0.2.
/// On the composite grid at dx = 0.4: 1 % at V = 10, 8 % at V = 20, up to 12 % at V = 30, 18 % at V = 50 and
/// 22 % at V = 100; at dx = 0.2 within 2 % up to V = 100. Below 1 the error does not depend on V.
double deformation_error(const Case& c) {
  if (!c.has_grid() || c.V <= 1) return 0;
  const double dx = c.fidelity.dx;
  return c.has_composite_grid() ? std::max(0., 0.25 * (c.V - 10) * std::pow(dx, 4)) : 0.09 * c.V * dx;
}

std::string viscosity_on_coarse_lattice(const Case& c) {
  constexpr double kMaxError = 0.1, kFinest = 0.05, kMaxMeasured = 0.22;
  const double error = deformation_error(c), order = c.has_composite_grid() ? 4 : 1;
  if (error < kMaxError) return "";
  const double fine_enough = c.fidelity.dx * std::pow(kMaxError / error, 1 / order);
  return "V = " + rounded(c.V) + " on a lattice of dx = " + rounded(c.fidelity.dx) +
         ": the deformation of round capsules comes out about " +
         rounded(100 * std::min(error, kMaxMeasured), 2) + " % too large; use \"fluid\": \"stokes\"" +
         (fine_enough >= kFinest ? ", or dx of at most " + rounded(fine_enough) : "");
}

std::string inside_too_thin_for_lattice(const Case& c) {
  if (!is_too_thin_for_lattice(c)) return "";
  return "inertia is Re/V = " + rounded(c.Re / c.V) +
         " times as large as viscosity in the inner fluid: the solution of the flow is likely to become "
         "unstable; use a smaller Re or a larger V";
}

/// Wrinkles change a sphere's D_xy at Ca = 0.0125 by 11 % with 2562 nodes. E_b = 0.0001 keeps spheres smooth
/// and lowers D_xy by 0.5 %. Red cells need more (Ca = 0.25, V = 4: 150 degrees between faces at E_b = 0, 109
/// at 0.001, 59 at 0.005).
std::string membrane_without_bending(const Case& c) {
  if (c.has_bending() || !is_compressed(c) || c.until.kt <= kFirstWrinkles) return "";
  const std::string enough = is_nearly_round(c) ? "0.0001" : "0.005";
  return "the membrane has no bending stiffness (E_b = 0) and wrinkles where it is compressed; the wrinkles "
         "are "
         "as wide as the edges of the mesh, and the result depends on them: use E_b = " +
         enough;
}

/// Two walls and the periodic images of the capsule change Q by a part that is proportional to 1/box³.
/// Measured in boxes of 6.4 and 12.8 (studies/cross_validation): the larger numbers are those of red cells.
std::string confinement(const Case& c) {
  constexpr double kWide = 10, kMeasuredBox = 12.8, kMinChange = 0.0017, kMaxChange = 0.035;
  if (!c.has_grid() || c.fidelity.box >= kWide) return "";
  const double narrower = std::pow(kMeasuredBox / c.fidelity.box, 3);
  return "a box of " + rounded(c.fidelity.box) +
         " a: its walls change Q = D_xy (cos 2 theta, sin 2 theta) by about " +
         rounded(kMinChange * narrower, 2) + " to " + rounded(kMaxChange * narrower, 2) +
         " (studies/cross_validation); for an unbounded fluid use a box of 25.6 or more, or \"fluid\": "
         "\"stokes\"";
}

/// Where no results were compared with those of other resolutions and of the other flow model.
std::string not_validated(const Case& c) {
  constexpr double kMinCa = 0.01, kMaxCa = 2, kMinV = 0.1, kMaxV = 20;
  std::string outside;
  if (c.Ca < kMinCa || c.Ca > kMaxCa) outside = "Ca = " + rounded(c.Ca) + " is outside 0.01 to 2";
  if (c.V < kMinV || c.V > kMaxV)
    outside += (outside.empty() ? "V = " : " and V = ") + rounded(c.V) + " is outside 0.1 to 20";
  if (outside.empty()) return "";
  return outside +
         ", where errors were measured: compare with a run of four times as many nodes, or with the "
         "other flow model (capstan compare)";
}

}  // namespace

bool is_too_thin_for_lattice(const Case& c) {
  constexpr double kMaxInertia = 12;
  return c.has_composite_grid() && c.V < 1 && c.Re > kMaxInertia * c.V;
}

std::vector<std::string> case_warnings(const Case& c) {
  std::vector<std::string> warnings;
  for (auto* warning : {neglected_inertia, membrane_without_bending, lattice_finer_than_mesh,
                        viscosity_on_coarse_lattice, inside_too_thin_for_lattice, confinement, not_validated})
    if (std::string text = warning(c); !text.empty()) warnings.push_back(std::move(text));
  return warnings;
}

}  // namespace capstan
