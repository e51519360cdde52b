#include "solver/fluid/lbm/collision.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "tests/support/quasisteady_rates.hpp"

namespace capstan {
namespace {

using testing::kQuasisteadyRates;

using namespace d3q19;
using Cell = std::array<double, kQ>;

/// The populations of one cell after the collision, computed in the type Real.
template <class Real = double>
Cell collided(const Cell& f, double s_nu, std::array<double, 3> force, const MrtRates& rates,
              double inertia) {
  std::array<Real, kQ> before{}, after{};
  std::array<Real, 4> coefficients = {Real(s_nu), Real(force[0]), Real(force[1]), Real(force[2])};
  CollisionRow<Real> row{};
  for (int q = 0; q < kQ; ++q) before[q] = Real(f[q]), row.f[q] = &before[q], row.f_star[q] = &after[q];
  row.s_nu = &coefficients[0];
  for (int c = 0; c < 3; ++c) row.force[c] = &coefficients[1 + c];
  row.count = 1;
  collide(row, rates, inertia);
  Cell out{};
  for (int q = 0; q < kQ; ++q) out[q] = double(after[q]);
  return out;
}

Cell random_cell(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  Cell f{};
  for (double& population : f) population = uniform(generator);
  return f;
}

double moment(const Cell& f, int k) {
  double sum = 0;
  for (int q = 0; q < kQ; ++q) sum += moment_row(k, q) * f[q];
  return sum;
}

/// Paper eq. 13 by matrix products, with the equilibrium of d'Humieres et al. 2002 for each moment.
Cell collided_by_matrices(const Cell& f, double s, std::array<double, 3> force, const MrtRates& r,
                          double inertia) {
  const double rho = moment(f, m_rho);
  const double x = moment(f, m_jx) + force[0] / 2, y = moment(f, m_jy) + force[1] / 2,
               z = moment(f, m_jz) + force[2] / 2;
  const double jj = x * x + y * y + z * z, c = inertia;
  const std::array<double, kQ> equilibrium = {rho,
                                              -11 * rho + 19 * c * jj,
                                              r.w_eps * rho + c * r.w_eps_j * jj,
                                              moment(f, m_jx),
                                              -2.0 / 3 * x,
                                              moment(f, m_jy),
                                              -2.0 / 3 * y,
                                              moment(f, m_jz),
                                              -2.0 / 3 * z,
                                              c * (2 * x * x - y * y - z * z),
                                              c * r.w_xx * (2 * x * x - y * y - z * z),
                                              c * (y * y - z * z),
                                              c * r.w_xx * (y * y - z * z),
                                              c * x * y,
                                              c * y * z,
                                              c * x * z,
                                              0,
                                              0,
                                              0};
  const std::array<double, kQ> rate = {0,    r.e, r.eps, 0, r.q, 0, r.q, 0,   r.q, s,
                                       r.pi, s,   r.pi,  s, s,   s, r.m, r.m, r.m};
  Cell out = f;
  for (int k = 0; k < kQ; ++k) {
    double change = -rate[k] * (moment(f, k) - equilibrium[k]);
    if (k == m_jx || k == m_jy || k == m_jz) change += force[(k - m_jx) / 2];
    for (int q = 0; q < kQ; ++q) out[q] += moment_row(k, q) / moment_norm2(k) * change;
  }
  return out;
}

TEST(D3Q19, RowsOfTheMomentMatrixAreOrthogonal) {
  for (int k = 0; k < kQ; ++k)
    for (int l = 0; l < k; ++l) {
      double product = 0;
      for (int q = 0; q < kQ; ++q) product += moment_row(k, q) * moment_row(l, q);
      EXPECT_EQ(product, 0) << k << " " << l;
    }
}

TEST(D3Q19, OppositeDirectionsCancel) {
  for (int q = 0; q < kQ; ++q) {
    EXPECT_EQ(e[q].x + e[opposite[q]].x, 0);
    EXPECT_EQ(e[q].y + e[opposite[q]].y, 0);
    EXPECT_EQ(e[q].z + e[opposite[q]].z, 0);
  }
}

constexpr MrtRates kDistinctRates = {1.1, 1.2, 1.3, 1.4, 1.5, 0.3, -0.7, -0.2};

TEST(Collision, EqualsTheMatrixFormOfThePaper) {
  const std::array<double, 3> force = {0.01, -0.02, 0.03};
  for (const MrtRates& rates : {kPaperRates, kQuasisteadyRates, kDistinctRates}) {
    const Cell f = random_cell(1);
    const Cell expected = collided_by_matrices(f, 1.3, force, rates, 2);
    const Cell found = collided(f, 1.3, force, rates, 2), in_float = collided<float>(f, 1.3, force, rates, 2);
    for (int q = 0; q < kQ; ++q) {
      EXPECT_NEAR(found[q], expected[q], 1e-15) << q;
      EXPECT_NEAR(in_float[q], expected[q], 2e-7) << q;
    }
  }
}

/// 37 cells: whole vectors and a remainder.
template <class Real>
void expect_row_of_cells_equals_its_cells() {
  constexpr int kCells = 37;
  std::vector<Cell> f, expected;
  std::vector<Real> numbers(kQ * kCells), zero(kCells, 0), s_nu(kCells);
  for (int x = 0; x < kCells; ++x) {
    f.push_back(random_cell(x));
    s_nu[x] = Real(1 + 0.01 * x);
    expected.push_back(collided<Real>(f[x], double(s_nu[x]), {0, 0, 0}, kPaperRates, 1));
    for (int q = 0; q < kQ; ++q) numbers[q * kCells + x] = Real(f[x][q]);
  }
  CollisionRow<Real> row{};
  for (int q = 0; q < kQ; ++q) row.f[q] = row.f_star[opposite[q]] = &numbers[q * kCells];
  row.s_nu = s_nu.data();
  for (const Real*& component : row.force) component = zero.data();
  row.count = kCells;
  collide(row, kPaperRates, 1);
  for (int x = 0; x < kCells; ++x)
    for (int q = 0; q < kQ; ++q) EXPECT_EQ(double(row.f_star[q][x]), expected[x][q]) << x << " " << q;
}

TEST(Collision, OfARowInPlaceEqualsThatOfEachCell) {
  expect_row_of_cells_equals_its_cells<float>();
  expect_row_of_cells_equals_its_cells<double>();
}

TEST(Collision, ConservesMassAndAddsTheForceToTheMomentum) {
  const Cell f = random_cell(2);
  const std::array<double, 3> force = {0.01, -0.02, 0.03};
  const Cell after = collided(f, 0.7, force, kPaperRates, 1);
  EXPECT_NEAR(moment(after, m_rho), moment(f, m_rho), 1e-15);
  EXPECT_NEAR(moment(after, m_jx), moment(f, m_jx) + force[0], 1e-15);
  EXPECT_NEAR(moment(after, m_jy), moment(f, m_jy) + force[1], 1e-15);
  EXPECT_NEAR(moment(after, m_jz), moment(f, m_jz) + force[2], 1e-15);
}

TEST(Collision, DoesNotChangeFluidAtRestWithExcessDensity) {
  Cell f{};
  for (int q = 0; q < kQ; ++q) f[q] = 0.1 * weight(q);
  const Cell after = collided(f, 1.1, {0, 0, 0}, kQuasisteadyRates, 1);
  for (int q = 0; q < kQ; ++q) EXPECT_NEAR(after[q], f[q], 1e-16);
}

}  // namespace
}  // namespace capstan
