#pragma once
// Populations between a grid and the next coarser one (cells of twice the edge, eight children a cell).
//
// All levels use the same relaxation rates and keep the numbers of the velocity. Then one lattice unit of the
// coarse level is twice as long and its time step four times: what is a derivative of the velocity doubles,
// and so do density and stress; second derivatives (energy flux) count four times. The conservation equations
// scale with their order: mass 2, momentum 4, stress 2. Differs from the paper, whose eq. 24 scales all
// residuals by 2: with these factors the contraction does not depend on the grid.
#include <array>

#include "solver/fluid/lbm/collision.hpp"
#include "solver/fluid/lbm/population_field.hpp"

namespace capstan {

class LevelTransfer {
 public:
  explicit LevelTransfer(const MrtRates& rates);

  /// coarse = I fine: mean of the children, moments scaled to coarse lattice units.
  void restrict_state(const PopulationField& fine, PopulationField& coarse) const;

  /// coarse = I' fine: mean of the children, moments scaled as the equations scale.
  void restrict_residual(const PopulationField& fine, PopulationField& coarse) const;

  /// The inverse of restrict_state's scaling, in place.
  void scale_to_finer(PopulationField& coarse) const;

 private:
  using PopulationMatrix = std::array<std::array<double, d3q19::kQ>, d3q19::kQ>;
  PopulationMatrix state_to_coarse_, residual_to_coarse_, state_to_fine_;
};

/// fine += trilinear interpolation of coarse, whose ghosts are filled.
void add_interpolated(const PopulationField& coarse, PopulationField& fine);

}  // namespace capstan
