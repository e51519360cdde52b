// The equation in moments is the paper's lattice Boltzmann equation with all free relaxation rates equal
// to 1.
#include "solver/fluid/quasisteady/moment_sweep.hpp"

#include <gtest/gtest.h>

#include <random>

#include "solver/fluid/paper/population_grid.hpp"
#include "solver/grid/row_field.hpp"
#include "tests/support/macroscopic.hpp"

namespace capstan {
namespace {

using d3q19::e;
using d3q19::kQ;
using d3q19::weight;
using testing::macroscopic;
using testing::Macroscopic;

constexpr IndexBox kCells{{0, 0, 0}, {21, 5, 4}};

template <class T>
RowField<T> random_field(int components, unsigned seed) {
  RowField<T> field(kCells, components);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<T> uniform(-1, 1);
  for (T& number : field.data()) number = uniform(generator);
  return field;
}

/// Random moments and stresses, and their values after one sweep over all cells.
template <class T>
struct Sweep {
  RowField<T> m = random_field<T>(kMoments, 1), d = random_field<T>(kMoments, 2), out{kCells, kMoments};
  RowField<T> c = random_field<T>(1, 3), p = random_field<T>(kStresses, 4), q = random_field<T>(kStresses, 6),
              p_d = random_field<T>(kStresses, 5), p_out{kCells, kStresses};

  FluidRow<T> row(int y, int z, T keep, T blend, T rate = 0) {
    return {m.row(0, y, z), d.row(0, y, z), out.row(0, y, z),  m.strides(), kCells.size(0), keep,
            blend,          keep,           blend / (1 + rate)};
  }
  void fluid(T keep, T blend) {
    for (int z = 0; z < kCells.hi[2]; ++z)
      for (int y = 0; y < kCells.hi[1]; ++y) sweep_fluid(row(y, z, keep, blend));
  }
  void stress(T keep, T blend, const ThinFluidFactors& thin = {}, T rate = 0) {
    for (int z = 0; z < kCells.hi[2]; ++z)
      for (int y = 0; y < kCells.hi[1]; ++y)
        sweep_stress(StressRow<T>{row(y, z, keep, blend, rate), c.row(0, y, z), q.row(0, y, z),
                                  p.row(0, y, z), p_d.row(0, y, z), p_out.row(0, y, z), p.strides(), keep,
                                  blend, T(thin.rho), T(thin.p), T(thin.g), T(thin.g) / (1 + rate)});
  }
};

/// The population that leaves the cell (x, y, z) along e_q, written as in moment_sweep.hpp (a).
double sent(const Sweep<double>& s, int q, int x, int y, int z) {
  const auto m = [&](int k) { return s.m.row(k, y, z)[x]; };
  const auto Q = [&](int k) { return s.q.row(k, y, z)[x]; };
  const double ex = e[q].x, ey = e[q].y, ez = e[q].z, zz = -Q(kXX) - Q(kYY);
  const double ee_Q = ex * ex * Q(kXX) + ey * ey * Q(kYY) + ez * ez * zz +
                      2 * (ex * ey * Q(kXY) + ex * ez * Q(kXZ) + ey * ez * Q(kYZ));
  return weight(q) * (m(kRho) + 3 * (ex * m(kGx) + ey * m(kGy) + ez * m(kGz)) + 4.5 * ee_Q);
}

TEST(MomentSweep, WithStressesGivesTheMomentsOfNineteenPopulations) {
  Sweep<double> s;
  s.stress(0.2, 0.7);
  for (int z = 0; z < kCells.hi[2]; ++z)
    for (int y = 0; y < kCells.hi[1]; ++y)
      for (int x = 0; x < kCells.hi[0]; ++x) {
        double rho = 0, gy = 0, xx = 0, yy = 0, zz = 0, xz = 0;
        for (int q = 0; q < kQ; ++q) {
          const double f = sent(s, q, x - e[q].x, y - e[q].y, z - e[q].z);
          rho += f, gy += e[q].y * f, xx += e[q].x * e[q].x * f, yy += e[q].y * e[q].y * f;
          zz += e[q].z * e[q].z * f, xz += e[q].x * e[q].z * f;
        }
        const auto relaxed = [&](const auto& before, const auto& defect, int k, double arrived) {
          return 0.2 * before.row(k, y, z)[x] + 0.7 * (arrived + defect.row(k, y, z)[x]);
        };
        EXPECT_NEAR(s.out.row(kRho, y, z)[x], relaxed(s.m, s.d, kRho, rho), 1e-13);
        EXPECT_NEAR(s.out.row(kGy, y, z)[x], relaxed(s.m, s.d, kGy, gy), 1e-13);
        EXPECT_NEAR(s.p_out.row(kYY, y, z)[x], relaxed(s.p, s.p_d, kYY, yy - (xx + yy + zz) / 3), 1e-13);
        EXPECT_NEAR(s.p_out.row(kXZ, y, z)[x], relaxed(s.p, s.p_d, kXZ, xz), 1e-13);
      }
}

template <class T>
double largest_difference(const RowField<T>& a, const RowField<T>& b) {
  double largest = 0;
  for (int z = 0; z < kCells.hi[2]; ++z)
    for (int y = 0; y < kCells.hi[1]; ++y)
      for (int k = 0; k < a.components(); ++k)
        for (int x = 0; x < kCells.hi[0]; ++x)
          largest = std::max(largest, std::abs(double(a.row(k, y, z)[x]) - double(b.row(k, y, z)[x])));
  return largest;
}

// Relaxation by gamma' = gamma - c factor of the cell. In unsteady flow the momentum tends to m**/(1 + rate).
TEST(MomentSweep, RelaxesEachCellByItsOwnFactorWhereTheFluidIsThin) {
  const double rate = 0.25;
  Sweep<double> thin, sent;
  thin.stress(0.3, 0.7, {.rho = 0.5, .g = -0.2, .p = 2}, rate);
  sent.stress(0, 1);
  for (int z = 0; z < kCells.hi[2]; ++z)
    for (int y = 0; y < kCells.hi[1]; ++y)
      for (int x = 0; x < kCells.hi[0]; ++x) {
        const auto expect_relaxed = [&](const auto& before, const auto& arrived, const auto& out, int k,
                                        double factor, double divisor) {
          const double gamma = 0.7 - factor * thin.c.row(0, y, z)[x];
          EXPECT_NEAR(out.row(k, y, z)[x],
                      (1 - gamma) * before.row(k, y, z)[x] + gamma * arrived.row(k, y, z)[x] / divisor,
                      1e-13);
        };
        expect_relaxed(thin.m, sent.out, thin.out, kRho, 0.5, 1);
        expect_relaxed(thin.m, sent.out, thin.out, kGx, -0.2, 1 + rate);
        expect_relaxed(thin.m, sent.out, thin.out, kGz, -0.2, 1 + rate);
        expect_relaxed(thin.p, sent.p_out, thin.p_out, kXY, 2, 1);
      }
}

TEST(MomentSweep, OfFluidIsTheSweepWithZeroStress) {
  Sweep<double> a, b;
  std::ranges::fill(b.q.data(), 0);
  a.fluid(0.1, 0.9);
  b.stress(0.1, 0.9);
  EXPECT_LT(largest_difference(a.out, b.out), 1e-14);
}

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
