// The equation in moments is the paper's lattice Boltzmann equation with all free relaxation rates equal
// to 1.
#include "solver/fluid/quasisteady/moment_sweep.hpp"

#include <gtest/gtest.h>

#include <random>

#include "solver/fluid/paper/population_grid.hpp"
#include "solver/grid/row_field.hpp"
#include "tests/support/macroscopic.hpp"
#include "tests/support/random_rows.hpp"

namespace capstan {
namespace {

using testing::largest_difference;
using testing::macroscopic;
using testing::Macroscopic;
using testing::random_rows;

constexpr IndexBox kCells{{0, 0, 0}, {21, 5, 4}};

/// Random moments, and their values after one sweep over all cells.
template <class T>
struct Sweep {
  RowField<T> m = random_rows<T>(kCells, kMoments, 1), d = random_rows<T>(kCells, kMoments, 2),
              out{kCells, kMoments};

  void fluid(T keep, T blend) {
    for (int z = 0; z < kCells.hi[2]; ++z)
      for (int y = 0; y < kCells.hi[1]; ++y)
        sweep_fluid(FluidRow<T>{m.row(0, y, z), d.row(0, y, z), out.row(0, y, z), m.strides(), kCells.size(0),
                                keep, blend, keep, blend});
  }
};

TEST(MomentSweep, InSinglePrecisionIsTheSweepInDoublePrecisionRounded) {
  Sweep<float> a;
  Sweep<double> b;
  std::ranges::copy(a.m.data(), b.m.data().begin());
  std::ranges::copy(a.d.data(), b.d.data().begin());
  a.fluid(0.1f, 0.9f);
  b.fluid(0.1, 0.9);
  RowField<double> rounded(kCells, kMoments);
  std::ranges::copy(a.out.data(), rounded.data().begin());
  EXPECT_LT(largest_difference(rounded, b.out), 1e-6);
}

/// With all rates 1 and viscosity 1/6 the next density and momentum of 19 populations are those of the sweep,
/// for any values of the other moments. Cells next to the walls are left out: there the two models differ
/// (moment_images.hpp).
TEST(MomentSweep, OfFluidIsTheMrtSchemeWithAllRatesOne) {
  constexpr MrtRates kOne = {1, 1, 1, 1, 1, 3, 0, 0};
  PopulationGrid grid(kCells, {.rates = kOne, .nu_lu = 1. / 6, .wall_speed = 0, .inertia = 0});
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (double& f : grid.populations().data()) f = uniform(generator);

  Sweep<double> s;
  std::ranges::fill(s.d.data(), 0);
  for (int z = -1; z <= kCells.hi[2]; ++z)
    for (int y = 0; y < kCells.hi[1]; ++y)
      for (int x = -1; x <= kCells.hi[0]; ++x) {
        const Macroscopic at =
            macroscopic(grid.populations(), periodic(x, kCells.hi[0]), y, periodic(z, kCells.hi[2]));
        s.m.row(kRho, y, z)[x] = at.rho, s.m.row(kGx, y, z)[x] = at.jx;
        s.m.row(kGy, y, z)[x] = at.jy, s.m.row(kGz, y, z)[x] = at.jz;
      }
  grid.step();
  s.fluid(0, 1);
  for (int z = 0; z < kCells.hi[2]; ++z)
    for (int y = 1; y < kCells.hi[1] - 1; ++y)
      for (int x = 0; x < kCells.hi[0]; ++x) {
        const Macroscopic after = macroscopic(grid.populations(), x, y, z);
        EXPECT_NEAR(s.out.row(kRho, y, z)[x], after.rho, 1e-12);
        EXPECT_NEAR(s.out.row(kGx, y, z)[x], after.jx, 1e-12);
        EXPECT_NEAR(s.out.row(kGy, y, z)[x], after.jy, 1e-12);
        EXPECT_NEAR(s.out.row(kGz, y, z)[x], after.jz, 1e-12);
      }
}

}  // namespace
}  // namespace capstan
