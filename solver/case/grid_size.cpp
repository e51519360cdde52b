#include "solver/case/grid_size.hpp"

#include <cmath>

namespace capstan {

SemiAxes semi_axes(const Case& c) {
  if (!c.has_aspect()) return {};
  return {std::pow(c.aspect, 2. / 3), std::pow(c.aspect, -1. / 3)};
}

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
