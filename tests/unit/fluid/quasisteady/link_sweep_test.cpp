#include "solver/fluid/quasisteady/link_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/fluid/lbm/d3q19.hpp"
#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/grid/row_field.hpp"
#include "tests/support/random_rows.hpp"

namespace capstan {
namespace {

using d3q19::e;
using d3q19::kQ;
using d3q19::opposite;
using d3q19::weight;
using testing::largest_difference;
using testing::random_rows;

constexpr IndexBox kSweptCells{{0, 0, 0}, {21, 5, 4}};

template <class T>
struct Rows {
  RowField<T> m = random_rows<T>(kSweptCells, kMoments, 1), d = random_rows<T>(kSweptCells, kMoments, 2),
              ratio = random_rows<T>(kSweptCells, 1, 3, T(0.1), 10), out{kSweptCells, kMoments};
  T dx = T(0.3), rate = 0, shear = 0, lift = 0;

  LinkRow<T> row(int y, int z) {
    return {m.row(0, y, z),
            d.row(0, y, z),
            out.row(0, y, z),
            m.strides(),
            ratio.row(0, y, z),
            ratio.strides(),
            kSweptCells.size(0),
            dx,
            rate,
            shear,
            lift};
  }
  template <class Visit>
  void for_each_row(Visit visit) {
    for (int z = 0; z < kSweptCells.hi[2]; ++z)
      for (int y = 0; y < kSweptCells.hi[1]; ++y) visit(y, z);
  }
  void relax(T gamma) {
    for_each_row([&](int y, int z) { relax_links(row(y, z), gamma); });
  }
  void residual() {
    for_each_row([&](int y, int z) { put_residual_of_links(row(y, z)); });
  }
};

/// The part of a population that is not in equilibrium, of the one that arrives at (x, y, z) along e_q, by
/// (a).
double arrived(const Rows<double>& s, int q, int x, int y, int z) {
  const int from_x = x - e[q].x, from_y = y - e[q].y, from_z = z - e[q].z;
  const double R = s.ratio.row(0, y, z)[x], other = s.ratio.row(0, from_y, from_z)[from_x];
  const auto change = [&](int k) { return s.m.row(k, from_y, from_z)[from_x] - s.m.row(k, y, z)[x]; };
  const double approach = e[q].x * change(kGx) + e[q].y * change(kGy) + e[q].z * change(kGz);
  const double density = s.m.row(kRho, y, z)[x], other_density = s.m.row(kRho, from_y, from_z)[from_x];
  return (R + 1) * weight(q) / (R + other) * (other * (other_density + 3 * approach) - R * density);
}

double equilibrium(const Rows<double>& s, int q, int x, int y, int z) {
  const auto m = [&](int k) { return s.m.row(k, y, z)[x]; };
  return weight(q) *
         (s.ratio.row(0, y, z)[x] * m(kRho) + 3 * (e[q].x * m(kGx) + e[q].y * m(kGy) + e[q].z * m(kGz)));
}

TEST(LinkSweep, ItsPopulationsAreThoseOfTheSteadyCollisionWithTwoRates) {
  const Rows<double> s;
  const int x = 7, y = 2, z = 1;
  for (int q = 1; q < kQ; ++q) {
    const int from_x = x - e[q].x, from_y = y - e[q].y, from_z = z - e[q].z;
    const double R = s.ratio.row(0, from_y, from_z)[from_x], c = (R - 1) / (R + 1);
    const double sent =
        equilibrium(s, q, from_x, from_y, from_z) + c * arrived(s, opposite[q], from_x, from_y, from_z);
    EXPECT_NEAR(equilibrium(s, q, x, y, z) + arrived(s, q, x, y, z), sent, 1e-13);
  }
}

TEST(LinkSweep, ResidualIsThatOfMassAndMomentumOfThesePopulations) {
  Rows<double> s;
  s.dx = 0;
  s.residual();
  const int x = 7, y = 2, z = 1;
  const double R = s.ratio.row(0, y, z)[x];
  double mass = 0, gy = 0;
  for (int q = 1; q < kQ; ++q) {
    mass += 2 / (R + 1) * arrived(s, q, x, y, z);
    gy += 2 * R / (R + 1) * e[q].y * arrived(s, q, x, y, z);
  }
  EXPECT_NEAR(s.out.row(kRho, y, z)[x], mass + s.d.row(kRho, y, z)[x], 1e-12);
  EXPECT_NEAR(s.out.row(kGy, y, z)[x], gy + s.d.row(kGy, y, z)[x], 1e-12);
}

TEST(LinkSweep, InAmbientFluidIsTheSweepOfMoments) {
  Rows<double> s;
  std::ranges::fill(s.ratio.data(), 1);
  s.dx = 0, s.rate = 0.25, s.shear = 0.1, s.lift = 0.2;
  RowField<double> expected(kSweptCells, kMoments);
  constexpr double kGamma = 0.7;
  s.for_each_row([&](int y, int z) {
    sweep_fluid(FluidRow<double>{s.m.row(0, y, z), s.d.row(0, y, z), expected.row(0, y, z), s.m.strides(),
                                 kSweptCells.size(0), 1 - kGamma, kGamma, 1 - kGamma, kGamma / (1 + s.rate),
                                 s.shear, s.lift});
  });
  s.relax(kGamma);
  EXPECT_LT(largest_difference(s.out, expected), 1e-13);
}

TEST(LinkSweep, CellsExertOppositeForcesOnEachOtherAndExchangeMass) {
  Rows<double> s;
  s.dx = 0;
  std::ranges::fill(s.d.data(), 0);
  const auto is_inside = [](int x, int y, int z) {
    return x > 1 && x < kSweptCells.hi[0] - 2 && y > 0 && y < kSweptCells.hi[1] - 1 && z > 0 &&
           z < kSweptCells.hi[2] - 1;
  };
  for (int k = 0; k < int(kMoments); ++k)
    for (int z = -1; z <= kSweptCells.hi[2]; ++z)
      for (int y = -1; y <= kSweptCells.hi[1]; ++y)
        for (int x = -1; x <= kSweptCells.hi[0]; ++x)
          if (!is_inside(x, y, z)) s.m.row(k, y, z)[x] = 0;
  s.residual();
  double sums[kMoments] = {};
  s.for_each_row([&](int y, int z) {
    for (int k = 0; k < int(kMoments); ++k)
      for (int x = 0; x < kSweptCells.hi[0]; ++x) sums[k] += s.out.row(k, y, z)[x];
  });
  for (const double sum : sums) EXPECT_NEAR(sum, 0, 1e-11);
}

TEST(LinkSweep, ShearFlowAcrossLayersOfAnyViscosityHasAUniformStress) {
  Rows<double> s;
  std::ranges::fill(s.m.data(), 0);
  std::ranges::fill(s.d.data(), 0);
  s.dx = 0;
  const auto ratio = [](int y) { return 1. + y * y; };
  double g = 0;
  for (int y = -1; y <= kSweptCells.hi[1]; ++y) {
    if (y >= 0) g += 0.3 * (1 / ratio(y - 1) + 1 / ratio(y));
    for (int z = -1; z <= kSweptCells.hi[2]; ++z)
      for (int x = -1; x <= kSweptCells.hi[0]; ++x)
        s.m.row(kGx, y, z)[x] = g, s.ratio.row(0, y, z)[x] = ratio(y);
  }
  s.residual();
  s.for_each_row([&](int y, int z) {
    for (int x = 0; x < kSweptCells.hi[0]; ++x) EXPECT_NEAR(s.out.row(kGx, y, z)[x], 0, 1e-13);
  });
}

TEST(LinkSweep, UndisturbedFlowIsAMomentumThatGrowsWithY) {
  Rows<double> with, without;
  without.dx = 0;
  for (int z = -1; z <= kSweptCells.hi[2]; ++z)
    for (int y = -1; y <= kSweptCells.hi[1]; ++y)
      for (int x = -1; x <= kSweptCells.hi[0]; ++x) without.m.row(kGx, y, z)[x] += with.dx * y;
  with.residual();
  without.residual();
  EXPECT_LT(largest_difference(with.out, without.out), 1e-12);
}

TEST(LinkSweep, RelaxationDoesNotChangeASolution) {
  Rows<double> s;
  s.rate = 0.25, s.shear = 2, s.lift = 1;  // convection stronger than viscosity
  s.residual();
  s.for_each_row([&](int y, int z) {
    for (int k = 0; k < int(kMoments); ++k)
      for (int x = 0; x < kSweptCells.hi[0]; ++x) s.d.row(k, y, z)[x] -= s.out.row(k, y, z)[x];
  });
  s.relax(0.9);
  EXPECT_LT(largest_difference(s.out, s.m), 1e-12);
}

TEST(LinkSweep, InSinglePrecisionIsTheSweepInDoublePrecisionRounded) {
  Rows<float> a;
  Rows<double> b;
  std::ranges::copy(a.m.data(), b.m.data().begin());
  std::ranges::copy(a.d.data(), b.d.data().begin());
  std::ranges::copy(a.ratio.data(), b.ratio.data().begin());
  a.relax(0.9f);
  b.relax(0.9);
  RowField<double> rounded(kSweptCells, kMoments);
  std::ranges::copy(a.out.data(), rounded.data().begin());
  EXPECT_LT(largest_difference(rounded, b.out), 1e-5);
}

}  // namespace
}  // namespace capstan
