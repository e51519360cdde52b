#include "solver/fluid/paper/population_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/lattice_scene.hpp"
#include "tests/support/macroscopic.hpp"
#include "tests/support/quasisteady_rates.hpp"

namespace capstan {
namespace {

using testing::kQuasisteadyRates;
using testing::macroscopic;

PopulationGridSettings settings_with(double nu_lu, double wall_speed) {
  return {.rates = kQuasisteadyRates, .nu_lu = nu_lu, .wall_speed = wall_speed, .gamma = 0.8};
}

VectorField all_velocities(const PopulationGrid& grid) {
  VectorField u;
  u.reset(grid.box());
  grid.velocity(u);
  return u;
}

TEST(PopulationGrid, CouetteFlowIsAnExactSteadyState) {
  for (const MrtRates& rates : {kPaperRates, kQuasisteadyRates}) {
    PopulationGridSettings settings = settings_with(0.1, 0.01);
    settings.rates = rates;
    settings.inertia = 0;
    PopulationGrid grid(box_from_zero({4, 12, 4}), settings);
    grid.set_couette();
    EXPECT_LT(grid.residual_norm(), 1e-18);
  }
}

TEST(PopulationGrid, MovingWallsDriveCouetteFlowFromRest) {
  PopulationGrid grid(box_from_zero({4, 8, 4}), settings_with(1.0 / 6, 0.01));
  for (int step = 0; step < 3000; ++step) grid.step();
  const VectorField u = all_velocities(grid);
  for (int y = 0; y < 8; ++y) EXPECT_NEAR(u.row(0, y, 1)[2], 0.01 * (y + 0.5 - 4) / 4, 1e-10);
}

/// Largest error of the flow u = F / (nu k^2) sin(k y) that the force F sin(k y), k = 2 pi / L, drives
/// between the walls, relative to its amplitude.
double error_of_sinusoidal_flow(int n) {
  const double nu = 0.1, wave = 2 * std::numbers::pi / n, amplitude = 1e-3 * nu * wave * wave;
  PopulationGrid grid(box_from_zero({4, n, 4}), settings_with(nu, 0));
  VectorField force;
  force.reset(grid.box());
  const auto shape = [&](int y) { return std::sin(wave * (y + 0.5 - 0.5 * n)); };
  for_each_row_in_order(force.box(),
                        [&](int y, int z) { std::fill_n(force.row(0, y, z), 4, amplitude * shape(y)); });
  grid.set_force(&force);
  for (int step = 0; step < 30 * n * n; ++step) grid.step();
  const VectorField u = all_velocities(grid);
  double worst = 0;
  for (int y = 0; y < n; ++y) worst = std::max(worst, std::abs(u.row(0, y, 0)[0] / 1e-3 - shape(y)));
  return worst;
}

TEST(PopulationGrid, AForcedFlowConvergesWithSecondOrder) {
  const double coarse = error_of_sinusoidal_flow(8), fine = error_of_sinusoidal_flow(16);
  EXPECT_LT(fine, 0.02);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3);
}

TEST(PopulationGrid, MultigridAndTimeSteppingReachTheSameSteadyState) {
  testing::LatticeScene scene(16, 3, settings_with(0.15, 1e-3));
  testing::LatticeScene stepped(16, 3, settings_with(0.15, 1e-3));
  for (int cycle = 0; cycle < 40; ++cycle) scene.cycle();
  for (int step = 0; step < 6000; ++step) stepped.finest().step();
  EXPECT_LT(relative_difference(all_velocities(scene.finest()), all_velocities(stepped.finest())), 1e-9);
}

TEST(PopulationGrid, SweepsAndCyclesConserveMass) {
  testing::LatticeScene scene(16, 5, settings_with(0.15, 1e-3));
  const auto mass = [&] {
    double sum = 0;
    for (int z = 0; z < 16; ++z)
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) sum += macroscopic(scene.finest().populations(), x, y, z).rho;
    return sum;
  };
  for (int cycle = 0; cycle < 5; ++cycle) scene.cycle();
  EXPECT_NEAR(mass(), 0, 1e-14);
}

}  // namespace
}  // namespace capstan
