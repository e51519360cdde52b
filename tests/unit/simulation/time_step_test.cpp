#include "solver/simulation/time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace capstan {
namespace {

/// Distance from the exact solution of dX/dt = (y, -x, -z) after t = 1, from (1, 0, 1).
double error_after_one(int steps) {
  Points x(3, 1), u(3, 1);
  x << 1, 0, 1;
  AdamsBashforth2 stepper(1.0 / (steps - 0.5));  // the last step is a half one
  for (double kt = 0; kt < 1;) {
    u << x(1), -x(0), -x(2);
    kt = stepper.advance({}, kt, 1, u, x).kt;
  }
  return (x.col(0) - Vec3(std::cos(1), -std::sin(1), std::exp(-1))).norm();
}

TEST(AdamsBashforth2, IsOfSecondOrder) {
  for (int steps : {50, 100, 200})
    EXPECT_NEAR(std::log2(error_after_one(steps) / error_after_one(2 * steps)), 2, 0.1) << steps;
}

TEST(AdamsBashforth2, IsExactForAConstantVelocity) {
  Points x = Points::Zero(3, 2);
  const Points u = Points::Constant(3, 2, 0.5);
  AdamsBashforth2 stepper(0.25);
  for (int n = 0; n < 8; ++n) stepper.advance({}, 0.25 * n, 2, u, x);
  EXPECT_EQ(x, Points::Constant(3, 2, 1));
}

TEST(AdamsBashforth2, ShortensItsLastStepToTheEndOfTheRun) {
  Points x = Points::Zero(3, 1);
  const Points u = Points::Ones(3, 1);
  AdamsBashforth2 stepper(0.4);
  double kt = 0;
  for (double expected : {0.4, 0.8, 1.0}) {
    kt = stepper.advance({}, kt, 1, u, x).kt;
    EXPECT_DOUBLE_EQ(kt, expected);
  }
  EXPECT_EQ(kt, 1);
  EXPECT_NEAR(x(0), 1, 1e-15);
}

}  // namespace
}  // namespace capstan
