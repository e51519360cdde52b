#include "solver/fluid/transient/in_place_lattice.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <random>

#include "solver/fluid/paper/population_grid.hpp"

namespace capstan {
namespace {

constexpr IndexBox kBox = box_from_zero({19, 6, 5});  // rows that are no whole number of vectors
constexpr int kCellsPerRow = kBox.size(0);

constexpr LatticeSettings kSettings = {.rates = kPaperRates, .nu_lu = 0.04, .wall_speed = 0.02};

/// Forces and viscosities that differ from cell to cell, next to a wall. Forces extend to both ends of the
/// rows; viscosities do not, since the ghosts of a PopulationGrid have the ambient one.
struct Disturbance {
  Disturbance() {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    force.reset({{0, 0, 1}, {19, 4, 4}});
    viscosity.reset({{1, 0, 1}, {18, 4, 4}});
    for_each_row_in_order(force.box(), [&](int y, int z) {
      for (int c = 0; c < 3; ++c)
        for (int x = 0; x < 19; ++x) force.row(c, y, z)[x] = 1e-3 * uniform(generator);
      for (int x = 0; x < 17; ++x) viscosity.row(0, y, z)[x] = 0.2 + 0.1 * uniform(generator);
    });
  }
  template <class Real>
  InPlaceLattice<Real> lattice() const {
    InPlaceLattice<Real> lattice(kBox, kSettings);
    lattice.set_couette();
    lattice.set_force(&force);
    lattice.set_viscosity(&viscosity);
    return lattice;
  }
  PopulationGrid grid() const {
    PopulationGrid grid(
        kBox, {.rates = kSettings.rates, .nu_lu = kSettings.nu_lu, .wall_speed = kSettings.wall_speed});
    grid.set_couette();
    grid.set_force(&force);
    grid.set_viscosity(viscosity);
    return grid;
  }
  VectorField force;
  ScalarField viscosity;
};

template <class Real>
std::vector<Real> all_populations(const InPlaceLattice<Real>& lattice) {
  std::vector<Real> all, row;
  for_each_row_in_order(kBox, [&](int y, int z) {
    lattice.read_row(y, z, row);
    all.insert(all.end(), row.begin(), row.end());
  });
  return all;
}

template <class Real>
double largest_difference(const InPlaceLattice<Real>& lattice, const PopulationGrid& grid) {
  double worst = 0;
  std::vector<Real> row;
  for_each_row_in_order(kBox, [&](int y, int z) {
    lattice.read_row(y, z, row);
    for (int q = 0; q < d3q19::kQ; ++q)
      for (int x = 0; x < kCellsPerRow; ++x)
        worst =
            std::max(worst, std::abs(double(row[q * kCellsPerRow + x]) - grid.populations().row(q, y, z)[x]));
  });
  return worst;
}

/// The largest difference after each of 31 steps, for both kinds of storage.
template <class Real>
double largest_difference_from_population_grid() {
  const Disturbance disturbance;
  InPlaceLattice<Real> lattice = disturbance.lattice<Real>();
  PopulationGrid grid = disturbance.grid();
  double worst = largest_difference(lattice, grid);
  for (int step = 0; step < 31; ++step) {
    lattice.step();
    grid.step();
    worst = std::max(worst, largest_difference(lattice, grid));
  }
  return worst;
}

// Populations are at most 2e-3.
TEST(InPlaceLattice, EqualsTheStepOfAPopulationGridToRoundOff) {
  EXPECT_LT(largest_difference_from_population_grid<double>(), 1e-17);
  EXPECT_LT(largest_difference_from_population_grid<float>(), 1e-8);
}

TEST(InPlaceLattice, VelocitiesEqualThoseOfAPopulationGrid) {
  const Disturbance disturbance;
  auto lattice = disturbance.lattice<double>();
  PopulationGrid grid = disturbance.grid();
  for (int step = 0; step < 4; ++step) {
    VectorField u, v;
    u.reset({{2, 1, 0}, {19, 6, 5}});
    v.reset(u.box());
    lattice.velocity(u);
    grid.velocity(v);
    EXPECT_LT(relative_difference(u, v), 1e-14);
    lattice.step();
    grid.step();
  }
}

TEST(InPlaceLattice, DoesNotDependOnTheNumberOfThreadsBitForBit) {
  const Disturbance disturbance;
  const auto populations_with = [&](int threads) {
    omp_set_num_threads(threads);
    auto lattice = disturbance.lattice<float>();
    for (int step = 0; step < 9; ++step) lattice.step();
    return all_populations(lattice);
  };
  const int before = omp_get_max_threads();
  const auto with_one = populations_with(1);
  EXPECT_EQ(populations_with(2), with_one);
  EXPECT_EQ(populations_with(3), with_one);
  omp_set_num_threads(before);
}

template <class Real>
void expect_resumed_equals_uninterrupted(int steps_before) {
  const Disturbance disturbance;
  auto lattice = disturbance.lattice<Real>(), resumed = disturbance.lattice<Real>();
  for (int step = 0; step < steps_before; ++step) lattice.step();
  StateArchive archive;
  lattice.save(archive);
  resumed.load(archive);
  for (int step = 0; step < 3; ++step) lattice.step(), resumed.step();
  EXPECT_EQ(all_populations(resumed), all_populations(lattice));
}

TEST(InPlaceLattice, ResumesFromAnySavedStepBitForBit) {
  for (int steps : {0, 1, 2, 3}) {
    expect_resumed_equals_uninterrupted<float>(steps);
    expect_resumed_equals_uninterrupted<double>(steps);
  }
}

TEST(InPlaceLattice, RefusesTheStateOfAnotherGrid) {
  const InPlaceLattice<double> other(box_from_zero({19, 5, 6}), kSettings);
  StateArchive archive;
  other.save(archive);
  auto lattice = Disturbance().lattice<double>();
  EXPECT_THROW(lattice.load(archive), std::runtime_error);
}

}  // namespace
}  // namespace capstan
