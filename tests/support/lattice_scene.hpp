#pragma once
// A sphere with a viscosity ratio and a force on its surface, as a multigrid cycle of a run has to solve for.
#include <cmath>
#include <numbers>
#include <span>

#include "solver/coupling/viscosity_field.hpp"
#include "solver/fluid/paper/level.hpp"
#include "solver/grid/full_approximation.hpp"

namespace capstan::testing {

/// Levels of n^3 cells for a domain of edge 12.8 with a unit sphere of viscosity ratio V in its middle.
class LatticeScene {
 public:
  LatticeScene(int n, double V, const LevelSettings& settings)
      : n_(n), levels_(make_levels({n, n, n}, settings)) {
    for (Level& level : levels_) level.set_couette();
    put_force(settings);
    levels_.front().set_force(&force_);
    if (V != 1) put_viscosity(V, settings.nu_lu);
  }

  void cycle() { fas_cycle(std::span(levels_), CycleShape{}); }
  Level& finest() { return levels_.front(); }

 private:
  double radius(int x, int y, int z) const { return std::hypot(coordinate(x), coordinate(y), coordinate(z)); }
  double coordinate(int i) const { return (i + 0.5 - 0.5 * n_) * 12.8 / n_; }
  double dx() const { return 12.8 / n_; }

  /// A force on the surface that resists the shear, with the shape of a stresslet.
  void put_force(const LevelSettings& settings) {
    force_.reset({n_ / 4, n_ / 4, n_ / 4}, {n_ / 2, n_ / 2, n_ / 2});
    force_.for_each_row([&](int y, int z) {
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
    ScalarBox nu;
    nu.reset({n_ / 4, n_ / 4, n_ / 4}, {n_ / 2, n_ / 2, n_ / 2});
    nu.for_each_row([&](int y, int z) {
      for (int i = 0, x = n_ / 4; i < n_ / 2; ++i, ++x)
        nu.row(0, y, z)[i] = ambient * (V + (1 - V) * smoothed_heaviside((radius(x, y, z) - 1) / dx()));
    });
    for (Level& level : levels_) {
      level.set_viscosity(nu);
      nu = coarsened(nu, ambient);
    }
  }

  int n_;
  std::vector<Level> levels_;
  VectorBox force_;
};

}  // namespace capstan::testing
