#include "solver/baseline/four_moment_lattice.hpp"

#include <gtest/gtest.h>

#include <random>

#include "solver/fluid/paper/population_grid.hpp"
#include "tests/support/macroscopic.hpp"

namespace capstan {
namespace {

using testing::macroscopic;
using testing::Macroscopic;

constexpr IndexBox kBox = box_from_zero({19, 6, 5});
constexpr double kWallSpeed = 0.01;

/// All rates 1 and the linear equilibrium w_q (rho + 3 e_q.j).
PopulationGrid grid_with_all_rates_one() {
  constexpr MrtRates kRates = {1, 1, 1, 1, 1, 3, -5.5, -0.5};
  return PopulationGrid(kBox, {.rates = kRates, .nu_lu = 1.0 / 6, .wall_speed = kWallSpeed, .inertia = 0});
}

template <class Visit>
void for_each_cell(Visit visit) {
  for_each_row_in_order(kBox, [&](int y, int z) {
    for (int x = 0; x < kBox.size(0); ++x) visit(x, y, z);
  });
}

/// Sets the same random moments in both.
template <class Real>
void disturb(PopulationGrid& grid, MomentField<Real>& moments) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-0.01, 0.01);
  for_each_cell([&](int x, int y, int z) {
    double m[4];
    for (int k = 0; k < 4; ++k) moments.row(k, y, z)[x] = Real(m[k] = uniform(generator));
    for (int q = 0; q < d3q19::kQ; ++q) {
      const auto e = d3q19::e[q];
      grid.populations().row(q, y, z)[x] =
          d3q19::weight(q) * (m[0] + 3 * (e.x * m[1] + e.y * m[2] + e.z * m[3]));
    }
    moments.close_row(y, z);
  });
}

template <class Real>
double difference_after(int steps) {
  PopulationGrid grid = grid_with_all_rates_one();
  FourMomentLattice<Real> lattice(kBox, kWallSpeed);
  disturb(grid, lattice.moments());
  for (int step = 0; step < steps; ++step) grid.step(), lattice.step();
  double worst = 0;
  for_each_cell([&](int x, int y, int z) {
    const Macroscopic m = macroscopic(grid.populations(), x, y, z);
    const double expected[4] = {m.rho, m.jx, m.jy, m.jz};
    for (int k = 0; k < 4; ++k)
      worst = std::max(worst, std::abs(double(lattice.moments().row(k, y, z)[x]) - expected[k]));
  });
  return worst;
}

TEST(FourMomentLattice, EqualsNineteenPopulationsWithAllRatesOneToRoundOff) {
  EXPECT_LT(difference_after<double>(1), 1e-17);
  EXPECT_LT(difference_after<double>(20), 1e-16);
  EXPECT_LT(difference_after<float>(20), 1e-7);
}

}  // namespace
}  // namespace capstan
