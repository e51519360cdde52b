// Backward differences with variable steps.
#include "solver/fluid/quasisteady/time_derivative.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace capstan {
namespace {

double derivative(const std::vector<double>& earlier, double t, const std::function<double(double)>& u) {
  const BackwardDifference d = backward_difference(earlier, t);
  const double before = earlier.size() > 1 ? d.before * u(earlier.front()) : d.before;
  return d.now * u(t) + d.last * u(earlier.back()) + before;
}

TEST(BackwardDifference, IsExactForParabolasAtUnequalSteps) {
  const auto parabola = [](double t) { return 2 - 3 * t + 5 * t * t; };
  for (double step : {0.1, 0.5, 1.3})
    EXPECT_NEAR(derivative({0.2, 0.7}, 0.7 + step, parabola), -3 + 10 * (0.7 + step), 1e-12) << step;
}

TEST(BackwardDifference, FromOneEarlierTimeIsExactForStraightLines) {
  EXPECT_NEAR(derivative({0.2}, 0.5, [](double t) { return 1 + 4 * t; }), 4, 1e-12);
}

TEST(BackwardDifference, OfEqualStepsHasTheWeightsThreeFourAndOneOverTwoSteps) {
  const BackwardDifference d = backward_difference(std::vector{0.0, 0.5}, 1.0);
  EXPECT_DOUBLE_EQ(d.now, 3);
  EXPECT_DOUBLE_EQ(d.last, -4);
  EXPECT_DOUBLE_EQ(d.before, 1);
}

// du/dt = -u from u(0) = 1 to t = 1: half the step, a quarter of the error.
TEST(BackwardDifference, DecaysWithAnErrorOfSecondOrderAfterAFirstStepOfFirstOrder) {
  const auto error = [](int steps) {
    std::vector<double> times = {0}, u = {1};
    for (int step = 1; step <= steps; ++step) {
      const double t = double(step) / steps;
      const BackwardDifference d = backward_difference(times, t);
      const double known = d.last * u.back() + d.before * u.front();
      times.push_back(t), u.push_back(-known / (d.now + 1));
      if (u.size() > 2) times.erase(times.begin()), u.erase(u.begin());
    }
    return std::abs(u.back() - std::exp(-1));
  };
  EXPECT_NEAR(std::log2(error(40) / error(80)), 2, 0.1);
}

}  // namespace
}  // namespace capstan
