#pragma once
// Transfer of populations between a grid and the next coarser one, of twice the spacing.
//
// All grids have the same relaxation rates, and velocities keep their values in lattice units. Then the
// lattice unit of length of the coarse grid is twice as long and its time step is four times as long. Moments
// that are proportional to first derivatives of the velocity (density and stress) double in value, those that
// are proportional to second derivatives (energy flux) are multiplied by four. Residuals scale with the order
// of their equation: mass 2, momentum 4, stress 2.
//
// Differs from the paper, whose eq. 24 multiplies all residuals by 2: with the factors above the contraction
// factor does not depend on the spacing.
#include <array>

#include "solver/fluid/lbm/collision.hpp"
#include "solver/grid/row_field.hpp"

namespace capstan {

class PopulationTransfer {
 public:
  explicit PopulationTransfer(const MrtRates& rates);

  /// coarse = I fine: mean of the children, moments scaled to the lattice units of the coarse grid.
  void restrict_state(const RowField<double>& fine, RowField<double>& coarse) const;

  /// coarse = I' fine: mean of the children, each moment multiplied by the factor of its residual.
  void restrict_residual(const RowField<double>& fine, RowField<double>& coarse) const;

  /// Scales the moments of a field on the coarse grid to the lattice units of the fine grid, in place.
  void scale_to_finer(RowField<double>& coarse) const;

 private:
  using PopulationMatrix = std::array<std::array<double, d3q19::kQ>, d3q19::kQ>;
  PopulationMatrix state_to_coarse_, residual_to_coarse_, state_to_fine_;
};

/// fine += trilinear interpolation of coarse, whose ghosts must be filled.
void add_interpolated(const RowField<double>& coarse, RowField<double>& fine);

}  // namespace capstan
