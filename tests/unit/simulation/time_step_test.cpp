#include "solver/simulation/time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace capstan {
namespace {

/// Distance from the exact solution of dX/dt = (y, -x, -z) after t = 1, from (1, 0, 1).
double error_after_one(int steps) {
  Points x(3, 1), u(3, 1);
  x << 1, 0, 1;
  AdamsBashforth2 stepper(1.0 / steps);
  for (int n = 0; n < steps; ++n) {
    u << x(1), -x(0), -x(2);
    stepper.advance({}, double(n) / steps, u, x);
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
  for (int n = 0; n < 8; ++n) EXPECT_EQ(stepper.advance({}, 0.25 * n, u, x).kt, 0.25 * (n + 1));
  EXPECT_EQ(x, Points::Constant(3, 2, 1));
}

}  // namespace
}  // namespace capstan
