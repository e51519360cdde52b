#pragma once
// Input for a multigrid cycle as in a run: a sphere with a viscosity ratio and a force on its surface.
#include <cmath>
#include <numbers>
#include <span>

#include "solver/coupling/viscosity_field.hpp"
#include "solver/fluid/paper/population_grid.hpp"
#include "solver/grid/for_each_row.hpp"
#include "solver/grid/full_approximation.hpp"

namespace capstan::testing {

/// Grids for a domain of edge 12.8, the finest of n^3 cells, with a unit sphere of viscosity ratio V at its
/// centre.
class LatticeScene {
 public:
  LatticeScene(int n, double V, const PopulationGridSettings& settings)
      : n_(n), grids_(make_population_grids(box_from_zero({n, n, n}), settings)) {
    for (PopulationGrid& grid : grids_) grid.set_couette();
    put_force(settings);
    grids_.front().set_force(&force_);
    if (V != 1) put_viscosity(V, settings.nu_lu);
  }

  void cycle() { fas_cycle(std::span(grids_), CycleShape{}); }
  PopulationGrid& finest() { return grids_.front(); }

 private:
  IndexBox middle() const {
    return {{n_ / 4, n_ / 4, n_ / 4}, {n_ / 4 + n_ / 2, n_ / 4 + n_ / 2, n_ / 4 + n_ / 2}};
  }
  double radius(int x, int y, int z) const { return std::hypot(coordinate(x), coordinate(y), coordinate(z)); }
  double coordinate(int i) const { return (i + 0.5 - 0.5 * n_) * 12.8 / n_; }
  double dx() const { return 12.8 / n_; }

  /// A force on the surface that resists the shear, with the shape of a stresslet.
  void put_force(const PopulationGridSettings& settings) {
    force_.reset(middle());
    for_each_row_in_order(middle(), [&](int y, int z) {
      for (int i = 0, x = n_ / 4; i < n_ / 2; ++i, ++x) {
        const double in_cells = (radius(x, y, z) - 1) / dx();
        const double shell = std::abs(in_cells) < 2 ? 1 + std::cos(std::numbers::pi * in_cells / 2) : 0;
        const double strength = settings.nu_lu * settings.wall_speed / n_ * shell;
        force_.row(0, y, z)[i] = -strength * coordinate(y);
        force_.row(1, y, z)[i] = -strength * coordinate(x);
      }
    });
  }

  void put_viscosity(double V, double ambient) {
    ScalarField nu;
    nu.reset(middle());
    for_each_row_in_order(middle(), [&](int y, int z) {
      for (int i = 0, x = n_ / 4; i < n_ / 2; ++i, ++x)
        nu.row(0, y, z)[i] =
            ambient * (V + (1 - V) * smoothed_heaviside((radius(x, y, z) - 1) / dx(), kPaperHalfWidth));
    });
    for (PopulationGrid& grid : grids_) {
      grid.set_viscosity(nu);
      nu = coarsened(nu, ambient);
    }
  }

  int n_;
  std::vector<PopulationGrid> grids_;
  VectorField force_;
};

}  // namespace capstan::testing
