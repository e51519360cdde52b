#include "solver/case/case_warnings.hpp"

#include <cmath>
#include <numbers>

#include "solver/case/choose_fluid.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

/// Warns if the flow model neglects inertia at a Reynolds number above the limit of the paper, fig. 10.
std::string neglected_inertia(const Case& c) {
  if (!neglects_inertia(c)) return "";
  return "Re = " + rounded(c.Re) +
         ": the quasi-steady flow neglects the time derivative, which matters from Re = 0.1 on; use "
         "\"fluid\": \"transient\"";
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

/// The jump of the viscosity is smoothed over some cells. Measured for spheres (Ca = 0.05 and 0.2, kt = 6, V
/// > 1): D is too large by about 0.09 V dx. With dx = 0.2 that is 8 % at V = 5, 18 % at 10, 63 % at 30 and
/// 150 to 200 % at 100; with dx = 0.1 about half. For V < 1 the error does not depend on V.
std::string viscosity_on_coarse_lattice(const Case& c) {
  constexpr double kErrorOfD = 0.09, kMaxError = 0.1, kFinest = 0.02;
  const double error = kErrorOfD * c.V * c.fidelity.dx, fine_enough = kMaxError / (kErrorOfD * c.V);
  if (!c.has_grid() || c.V <= 1 || error < kMaxError) return "";
  return "V = " + rounded(c.V) + " on a lattice of dx = " + rounded(c.fidelity.dx) +
         ": the jump of the viscosity is smoothed over some cells, and the deformation of round capsules "
         "comes out about " +
         rounded(100 * error) + " % too large; use \"fluid\": \"stokes\"" +
         (fine_enough >= kFinest ? ", or dx of at most " + rounded(fine_enough) : "");
}

}  // namespace

std::vector<std::string> case_warnings(const Case& c) {
  std::vector<std::string> warnings;
  for (auto* warning : {neglected_inertia, lattice_finer_than_mesh, viscosity_on_coarse_lattice})
    if (std::string text = warning(c); !text.empty()) warnings.push_back(std::move(text));
  return warnings;
}

}  // namespace capstan
