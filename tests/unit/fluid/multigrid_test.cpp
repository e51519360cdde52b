// The promise of the quasi-steady flow: a few cycles, whatever the grid and the viscosities.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/fluid/lattice/quasisteady_lbm.hpp"
#include "tests/support/lattice_scene.hpp"

namespace capstan {
namespace {

/// Mean contraction of the residual over the cycles that reduce it by 1e-4 after the first.
double contraction(int n, double V) {
  Case c;
  c.Re = 0.05;
  c.V = V;
  c.fidelity.dx = c.fidelity.box / n;
  testing::LatticeScene scene(n, V, quasisteady_settings(c));
  scene.cycle();
  const double first = scene.finest().residual_norm();
  int cycles = 0;
  double last = first;
  while (last > 1e-4 * first && cycles < 60) {
    scene.cycle();
    last = scene.finest().residual_norm();
    ++cycles;
  }
  return std::pow(last / first, 1.0 / cycles);
}

TEST(Multigrid, ContractsByThirtyFivePercentOrBetterWithoutViscosityContrast) {
  EXPECT_LE(contraction(16, 1), 0.35);
  EXPECT_LE(contraction(32, 1), 0.35);
  EXPECT_LE(contraction(64, 1), 0.35);
}

TEST(Multigrid, ContractsBySixtyPercentOrBetterAtTenfoldViscosityContrast) {
  for (double V : {0.1, 10.0}) {
    EXPECT_LE(contraction(32, V), 0.6) << "V = " << V;
    EXPECT_LE(contraction(64, V), 0.6) << "V = " << V;
  }
}

}  // namespace
}  // namespace capstan
