#include "solver/case/grid_size.hpp"

#include <cmath>

#include "solver/case/shown_number.hpp"
#include "solver/grid/halved_cells.hpp"

namespace capstan {

SemiAxes semi_axes(const Case& c) {
  if (!c.has_aspect()) return {};
  return {std::pow(c.aspect, 2. / 3), std::pow(c.aspect, -1. / 3)};
}

std::string issue_of_grid(const Case& c) {
  constexpr int kMaxCoarsest =
      24;  // cells along an edge of the coarsest grid, which is solved by sweeps alone
  const double cells = c.fidelity.box / c.fidelity.dx;
  if (std::abs(cells - std::round(cells)) > 1e-9 * cells || std::lround(cells) % 8 != 0)
    return "box/dx is " + shown(cells) + ", must be a multiple of 8 so that the grid can be coarsened";
  if (c.has_composite_grid() && halved_cells(int(std::lround(cells))).back() > kMaxCoarsest)
    return "box/dx is " + shown(cells) + ", which cannot be halved until 24 or less are left; try " +
           shown(std::exp2(std::round(std::log2(cells))));
  return "";
}

double usual_box(const Case& c) { return c.has_composite_grid() ? 25.6 : 12.8; }

double uniform_cells(const Case& c) { return std::pow(c.fidelity.box / c.fidelity.dx, 3); }

double composite_cells(const Case& c) {
  constexpr double kStretch = 0.6, kMargins = 12;  // growth of the box as the capsule deforms, / a; margins
                                                   // of the box on both sides, in cells
  const auto [axis, across] = semi_axes(c);
  const auto cells_along = [&](double semi_axis) {
    return (2 * semi_axis + kStretch) / c.fidelity.dx + kMargins;
  };
  const double in_plane = std::sqrt((axis * axis + across * across) / 2);
  const double share = c.fidelity.symmetry == Symmetry::automatic ? 0.25 : 1;
  return share * std::pow(cells_along(in_plane), 2) * cells_along(across);
}

}  // namespace capstan
