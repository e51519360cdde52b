#include "solver/fluid/transient/in_place_lattice.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <random>

#include "solver/fluid/paper/level.hpp"

namespace capstan {
namespace {

constexpr Extent kExtent = {19, 6, 5};  // rows that fill no whole number of vectors

constexpr LatticeSettings kSettings = {.rates = kPaperRates, .nu_lu = 0.04, .wall_speed = 0.02};

/// Forces and viscosities that differ from cell to cell, beside a wall; forces up to both ends of the rows,
/// viscosities not: the ghosts of a Level have the ambient one.
struct Disturbance {
  Disturbance() {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    force.reset({0, 0, 1}, {19, 4, 3});
    viscosity.reset({1, 0, 1}, {17, 4, 3});
    force.for_each_row([&](int y, int z) {
      for (int c = 0; c < 3; ++c)
        for (int x = 0; x < 19; ++x) force.row(c, y, z)[x] = 1e-3 * uniform(generator);
      for (int x = 0; x < 17; ++x) viscosity.row(0, y, z)[x] = 0.2 + 0.1 * uniform(generator);
    });
  }
  template <class Real>
  InPlaceLattice<Real> lattice() const {
    InPlaceLattice<Real> lattice(kExtent, kSettings);
    lattice.set_couette();
    lattice.set_force(&force);
    lattice.set_viscosity(&viscosity);
    return lattice;
  }
  Level level() const {
    Level level(kExtent,
                {.rates = kSettings.rates, .nu_lu = kSettings.nu_lu, .wall_speed = kSettings.wall_speed});
    level.set_couette();
    level.set_force(&force);
    level.set_viscosity(viscosity);
    return level;
  }
  VectorBox force;
  ScalarBox viscosity;
};

template <class Real>
std::vector<Real> all_populations(const InPlaceLattice<Real>& lattice) {
  std::vector<Real> all, row;
  for (int z = 0; z < kExtent.nz; ++z)
    for (int y = 0; y < kExtent.ny; ++y) {
      lattice.read_row(y, z, row);
      all.insert(all.end(), row.begin(), row.end());
    }
  return all;
}

template <class Real>
double largest_difference(const InPlaceLattice<Real>& lattice, const Level& level) {
  double worst = 0;
  std::vector<Real> row;
  for (int z = 0; z < kExtent.nz; ++z)
    for (int y = 0; y < kExtent.ny; ++y) {
      lattice.read_row(y, z, row);
      for (int q = 0; q < d3q19::kQ; ++q)
        for (int x = 0; x < kExtent.nx; ++x)
          worst = std::max(worst,
                           std::abs(double(row[q * kExtent.nx + x]) - level.populations()[q].row(y, z)[x]));
    }
  return worst;
}

/// Over 31 steps: after each of them, in both places that populations have.
template <class Real>
double largest_difference_from_level() {
  const Disturbance disturbance;
  InPlaceLattice<Real> lattice = disturbance.lattice<Real>();
  Level level = disturbance.level();
  double worst = largest_difference(lattice, level);
  for (int step = 0; step < 31; ++step) {
    lattice.step();
    level.step();
    worst = std::max(worst, largest_difference(lattice, level));
  }
  return worst;
}

// Populations are up to 2e-3.
TEST(InPlaceLattice, EqualsTheStepOfALevelToRoundOff) {
  EXPECT_LT(largest_difference_from_level<double>(), 1e-17);
  EXPECT_LT(largest_difference_from_level<float>(), 1e-8);
}

TEST(InPlaceLattice, VelocitiesEqualThoseOfALevel) {
  const Disturbance disturbance;
  auto lattice = disturbance.lattice<double>();
  Level level = disturbance.level();
  for (int step = 0; step < 4; ++step) {
    VectorBox u, v;
    u.reset({2, 1, 0}, {17, 5, 5});
    v.reset({2, 1, 0}, {17, 5, 5});
    lattice.velocity(u);
    level.velocity(v);
    EXPECT_LT(relative_difference(u, v), 1e-14);
    lattice.step();
    level.step();
  }
}

TEST(InPlaceLattice, NumberOfThreadsChangesNoBit) {
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

TEST(InPlaceLattice, GoesOnFromAnySavedStepToTheLastBit) {
  for (int steps : {0, 1, 2, 3}) {
    expect_resumed_equals_uninterrupted<float>(steps);
    expect_resumed_equals_uninterrupted<double>(steps);
  }
}

TEST(InPlaceLattice, RefusesTheStateOfAnotherGrid) {
  const InPlaceLattice<double> other({kExtent.nx, kExtent.nz, kExtent.ny}, kSettings);
  StateArchive archive;
  other.save(archive);
  auto lattice = Disturbance().lattice<double>();
  EXPECT_THROW(lattice.load(archive), std::runtime_error);
}

}  // namespace
}  // namespace capstan
