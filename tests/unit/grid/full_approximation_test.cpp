#include "solver/grid/full_approximation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace capstan {
namespace {

/// -u'' + u^3 = b on (0, 1), u = 0 at the ends, by second-order differences and damped Jacobi sweeps. A
/// problem without a lattice, and nonlinear, so that full approximation storage is needed.
class NonlinearPoisson {
 public:
  explicit NonlinearPoisson(int intervals)
      : u(intervals + 1), b(intervals + 1), start(intervals + 1), h(1.0 / intervals) {}

  double apply(const std::vector<double>& v, size_t i) const {
    return (2 * v[i] - v[i - 1] - v[i + 1]) / (h * h) + v[i] * v[i] * v[i];
  }
  double residual(size_t i) const { return b[i] - apply(u, i); }
  double residual_norm() const {
    double sum = 0;
    for (size_t i = 1; i + 1 < u.size(); ++i) sum += residual(i) * residual(i);
    return std::sqrt(sum * h);
  }

  void relax() {
    std::vector<double> next = u;
    for (size_t i = 1; i + 1 < u.size(); ++i)
      next[i] += 2.0 / 3 * residual(i) / (2 / (h * h) + 3 * u[i] * u[i]);
    u = next;
  }
  void restrict_to(NonlinearPoisson& coarse) {
    for (size_t i = 1; i + 1 < coarse.u.size(); ++i) coarse.u[i] = u[2 * i];
    coarse.start = coarse.u;
    for (size_t i = 1; i + 1 < coarse.u.size(); ++i)
      coarse.b[i] = coarse.apply(coarse.u, i) +
                    0.25 * (residual(2 * i - 1) + 2 * residual(2 * i) + residual(2 * i + 1));
  }
  void correct_from(const NonlinearPoisson& coarse) {
    const auto change = [&](size_t i) { return coarse.u[i] - coarse.start[i]; };
    for (size_t i = 1; i + 1 < u.size(); ++i)
      u[i] += i % 2 == 0 ? change(i / 2) : 0.5 * (change(i / 2) + change(i / 2 + 1));
  }

  std::vector<double> u, b, start;
  double h;
};

std::vector<NonlinearPoisson> hierarchy(int intervals) {
  std::vector<NonlinearPoisson> levels;
  for (int n = intervals; n >= 4; n /= 2) levels.emplace_back(n);
  for (size_t i = 1; i + 1 < levels[0].u.size(); ++i)
    levels[0].b[i] = 100 * std::sin(7 * levels[0].h * double(i));
  return levels;
}

int cycles_to_reduce(double factor, int intervals) {
  auto levels = hierarchy(intervals);
  const double first = levels[0].residual_norm();
  int cycles = 0;
  while (levels[0].residual_norm() > factor * first && cycles < 100)
    fas_cycle(std::span(levels), CycleShape{}), ++cycles;
  return cycles;
}

TEST(FasCycle, SolvesANonlinearProblemInAFewCyclesOnEveryGrid) {
  for (int intervals : {32, 128, 512}) EXPECT_LE(cycles_to_reduce(1e-8, intervals), 9) << intervals;
}

TEST(FasCycle, DoesNotChangeASolution) {
  auto levels = hierarchy(64);
  for (int cycle = 0; cycle < 30; ++cycle) fas_cycle(std::span(levels), CycleShape{});
  const std::vector<double> solution = levels[0].u;
  fas_cycle(std::span(levels), CycleShape{});
  for (size_t i = 0; i < solution.size(); ++i) EXPECT_NEAR(levels[0].u[i], solution[i], 1e-12);
}

TEST(FasCycle, OnOneLevelDoesTheSweepsOfTheCoarsest) {
  auto levels = hierarchy(4);
  const double before = levels[0].residual_norm();
  fas_cycle(std::span(levels), CycleShape{.coarsest = 20});
  EXPECT_LT(levels[0].residual_norm(), 1e-3 * before);
}

}  // namespace
}  // namespace capstan
