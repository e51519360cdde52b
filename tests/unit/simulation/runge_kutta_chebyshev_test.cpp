#include "solver/simulation/runge_kutta_chebyshev.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace capstan {
namespace {

/// x' = y, y' = -x, and z decays towards cos t at a rate.
VelocityField circle_and_decay(double rate) {
  return [=](double kt, const Points& x, Points& u) -> FlowReport {
    u.resize(3, 1);
    u << x(1), -x(0), -rate * (x(2) - std::cos(kt)) - std::sin(kt);
    return {.iterations = 1};
  };
}

/// Distance from the exact solution after the step that reaches the end.
double error_of_run(RungeKuttaChebyshev stepper, const VelocityField& field, double end) {
  Points x(3, 1), u(3, 1);
  x << 0, 1, 1;
  double kt = 0;
  while (kt < end) {
    field(kt, x, u);
    const StepReport step = stepper.advance(field, kt, u, x);
    EXPECT_TRUE(step.flow.converged);
    EXPECT_GT(step.kt, kt);
    kt = step.kt;
  }
  return (x.col(0) - Vec3(std::sin(kt), std::cos(kt), std::cos(kt))).norm();
}

TEST(RungeKuttaChebyshev, IsOfSecondOrder) {
  const auto error = [](double step) {
    return error_of_run(RungeKuttaChebyshev({.tolerance = 1, .largest_step = step, .soft_step = step}),
                        circle_and_decay(1), 1);
  };
  // it starts with a tenth of the largest step, so that the error of a step is not known beforehand
  EXPECT_NEAR(std::log2(error(0.05) / error(0.025)), 2, 0.35);
  EXPECT_NEAR(std::log2(error(0.025) / error(0.0125)), 2, 0.35);
}

TEST(RungeKuttaChebyshev, ToleranceBoundsTheErrorOfAStiffProblem) {
  for (double tolerance : {1e-3, 1e-4, 1e-5})
    EXPECT_LT(error_of_run(RungeKuttaChebyshev({.tolerance = tolerance}), circle_and_decay(1000), 2),
              40 * tolerance)
        << tolerance;
}

TEST(RungeKuttaChebyshev, NeedsFlowSolutionsInProportionToTheRootOfTheStiffness) {
  const auto flows = [](double rate) {
    int calls = 0;
    error_of_run(
        RungeKuttaChebyshev(),
        [&](double, const Points& x, Points& u) -> FlowReport {
          ++calls;
          u << x(1), -x(0), -rate * (x(2) - x(0) / rate);
          return {.iterations = 1};
        },
        4);
    return calls;
  };
  EXPECT_LT(flows(16000), 6 * flows(1000));  // explicit Euler would need 16 times as many
}

TEST(RungeKuttaChebyshev, TakesLongerStepsWhereTheMembraneIsSoft) {
  const auto longest_step = [](double rate) {
    RungeKuttaChebyshev stepper({.tolerance = 1, .largest_step = 0.1, .soft_step = 0.2});
    const VelocityField field = circle_and_decay(rate);
    Points x(3, 1), u(3, 1);
    x << 0, 1, 1.01;
    double longest = 0;
    for (double kt = 0; kt < 2;) {
      field(kt, x, u);
      const double before = std::exchange(kt, stepper.advance(field, kt, u, x).kt);
      longest = std::max(longest, kt - before);
    }
    return longest;
  };
  EXPECT_NEAR(longest_step(1), 0.2, 1e-6);
  EXPECT_NEAR(longest_step(1000), 0.1, 1e-6);
}

TEST(RungeKuttaChebyshev, EstimatesTheFastestDecayRate) {
  const VelocityField field = circle_and_decay(300);
  RungeKuttaChebyshev stepper;
  Points x(3, 1), u(3, 1);
  x << 0, 1, 1.01;
  field(0, x, u);
  stepper.advance(field, 0, u, x);
  EXPECT_NEAR(stepper.spectral_radius(), 1.2 * 300, 0.1 * 300);
}

TEST(RungeKuttaChebyshev, AFailedFlowSolutionIsRepeatedWithASmallerStep) {
  const VelocityField well = circle_and_decay(1);
  int lost = 0;
  const VelocityField field = [&](double kt, const Points& x, Points& u) {
    return kt > 0 && lost < 3 ? (++lost, lost_flow("for a while")) : well(kt, x, u);
  };
  EXPECT_LT(error_of_run(RungeKuttaChebyshev(), field, 0.1), 1e-3);
  EXPECT_EQ(lost, 3);
}

TEST(RungeKuttaChebyshev, AFlowThatAlwaysFailsStopsTheRunWithItsReason) {
  const VelocityField lost = [](double, const Points&, Points&) { return lost_flow("no flow at all"); };
  RungeKuttaChebyshev stepper;
  Points x = Points::Zero(3, 1);
  const FlowReport report = stepper.advance(lost, 0, Points::Ones(3, 1), x).flow;
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.reason, "no flow at all");
}

TEST(RungeKuttaChebyshev, StopsIfTheMembraneBecomesFarStifferThanAtItsStart) {
  const VelocityField field = [](double kt, const Points& x, Points& u) {
    return circle_and_decay(std::pow(10, 1 + 8 * kt))(kt, x, u);
  };
  RungeKuttaChebyshev stepper;
  Points x(3, 1), u(3, 1);
  x << 0, 1, 1.01;
  StepReport step{.kt = 0, .flow = {}};
  while (step.flow.converged && step.kt < 1) {
    field(step.kt, x, u);
    step = stepper.advance(field, step.kt, u, x);
  }
  EXPECT_NEAR(step.kt, 0.62, 0.1);  // where the rate is 1e6
  EXPECT_EQ(step.flow.reason, "the membrane has become thousands of times as stiff as it was");
}

}  // namespace
}  // namespace capstan
