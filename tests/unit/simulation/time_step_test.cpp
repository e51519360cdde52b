#include "solver/simulation/time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/simulation/simulation.hpp"

namespace capstan {
namespace {

/// Distance from the exact solution of dX/dt = (y, -x, -z) after t = 1, from (1, 0, 1).
double error_after_one(int steps) {
  Points x(3, 1), u(3, 1);
  x << 1, 0, 1;
  AdamsBashforth2 stepper;
  for (int n = 0; n < steps; ++n) {
    u << x(1), -x(0), -x(2);
    stepper.advance({}, double(n) / steps, double(n + 1) / steps, u, x);
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
  AdamsBashforth2 stepper;
  for (int n = 0; n < 8; ++n) stepper.advance({}, 0.25 * n, 0.25 * (n + 1), u, x);
  EXPECT_EQ(x, Points::Constant(3, 2, 1));
}

Case recorded_every(double history_every, double shapes_every) {
  Case c;
  c.until.kt = 2;
  c.fidelity.kdt = 0.04;
  c.outputs = {.history_every = history_every, .shapes_every = shapes_every};
  return c;
}

TEST(TimeGrid, EndsAtTheStepNearestToTheWishedTime) {
  EXPECT_EQ(TimeGrid(recorded_every(0.1, 1), std::nullopt).steps, 50);
  EXPECT_EQ(TimeGrid(recorded_every(0.1, 1), 0.3).steps, 7);
  EXPECT_EQ(TimeGrid(recorded_every(0.1, 1), 1e-4).steps, 20000);
}

TEST(TimeGrid, ModelThatImposesItsStepHasIt) {
  EXPECT_EQ(TimeGrid(recorded_every(0.1, 1), std::nullopt).kdt, 0.04);
  EXPECT_EQ(TimeGrid(recorded_every(0.1, 1), 1e-4).kdt, 1e-4);
}

TEST(TimeGrid, ShapesAreRecordedAtRecordedTimes) {
  const TimeGrid grid(recorded_every(0.08, 0.5), std::nullopt);
  EXPECT_EQ(grid.steps_a_record, 2);
  EXPECT_EQ(grid.steps_a_shape, 12);
}

TEST(TimeGrid, IntervalsBelowAStepMeanEveryStep) {
  const TimeGrid grid(recorded_every(1e-3, 1e-3), std::nullopt);
  EXPECT_EQ(grid.steps_a_record, 1);
  EXPECT_EQ(grid.steps_a_shape, 1);
}

TEST(TimeGrid, IntervalOfZeroMeansNoShapes) {
  EXPECT_EQ(TimeGrid(recorded_every(0.1, 0), std::nullopt).steps_a_shape, 0);
}

}  // namespace
}  // namespace capstan
