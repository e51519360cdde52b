#include "solver/observe/classify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace capstan {
namespace {

using std::numbers::pi;

/// What a run records at one time.
struct State {
  double D_xy, theta, psi;
};

History history(double end, const std::function<State(double)>& at) {
  History records;
  for (int n = 0; n <= std::lround(end / 0.1); ++n) {
    Record record;
    record.kt = 0.1 * n;
    const State state = at(record.kt);
    record.D_xy = state.D_xy;
    record.theta = state.theta;
    record.psi = state.psi;
    records.push_back(record);
  }
  return records;
}

/// A curve through values given every kt = 4 from kt = 2 on, straight in between.
double interpolated(const std::vector<double>& values, double kt) {
  const double place = std::clamp((kt - 2) / 4, 0.0, static_cast<double>(values.size()) - 1.001);
  const auto n = static_cast<size_t>(place);
  return values[n] + (place - static_cast<double>(n)) * (values[n + 1] - values[n]);
}

State rigid_spheroid(double kt, double D_xy, double aspect) {  // Jeffery: turns by pi in kt = pi (a/b + b/a)
  const double t = kt / (aspect + 1 / aspect);
  return {D_xy, std::atan2(-aspect * std::sin(t), std::cos(t)) - 2 * pi * std::floor((t + pi) / (2 * pi)), 0};
}

/// A swinging tank-treader: the shape oscillates twice in each turn of the membrane.
State swinging(double kt, double D_xy = 0.4, double half_turn = 8) {
  const double phase = pi * kt / half_turn;
  return {D_xy + 0.1 * std::cos(2 * phase), 0.1 * std::sin(2 * phase), -phase};
}

TEST(Classify, ARigidSpheroidTumbles) {
  const Verdict verdict = classify(history(30, [](double kt) { return rigid_spheroid(kt, 1.0 / 3, 0.5); }));
  EXPECT_EQ(verdict.motion, Motion::tumbling);
  EXPECT_NEAR(verdict.evidence.r, 1, 1e-12);
  EXPECT_NEAR(verdict.evidence.D_min, 1.0 / 3, 0.01);
  EXPECT_NEAR(verdict.evidence.theta_range, pi, 0.15);
  EXPECT_TRUE(verdict.certain);
}

TEST(Classify, ASteadySphereWithATurningMembraneTankTreads) {
  const Verdict verdict = classify(history(30, [](double kt) {
    return State{0.27 * (1 - std::exp(-3 * kt)), pi * (0.17 + 0.08 * std::exp(-3 * kt)), -kt / 2};
  }));
  EXPECT_EQ(verdict.motion, Motion::tank_treading);
  EXPECT_NEAR(verdict.evidence.n_psi, 27 / (2 * pi), 1e-2);
  EXPECT_NEAR(verdict.evidence.theta_range, 0, 1e-3);
  EXPECT_TRUE(verdict.certain);
}

TEST(Classify, ASteadyShapeThatHardlyDeformsIsNoPassageThroughZero) {
  for (double D_xy : {0.08, 0.03, 0.001}) {
    const Verdict verdict = classify(history(20, [&](double kt) { return State{D_xy, 0.7, -kt / 2}; }));
    EXPECT_EQ(verdict.motion, Motion::tank_treading) << D_xy;
  }
}

TEST(Classify, AStiffSpheroidOfAspectNineTenthsTumblesThoughItsDeformationIsSmall) {
  const Verdict verdict = classify(history(30, [](double kt) { return rigid_spheroid(kt, 0.0526, 0.9); }));
  EXPECT_EQ(verdict.motion, Motion::tumbling);
}

TEST(Classify, SwingingIsTankTreading) {
  const Verdict verdict = classify(history(30, [](double kt) { return swinging(kt); }));
  EXPECT_EQ(verdict.motion, Motion::tank_treading);
  EXPECT_NEAR(verdict.evidence.theta_range, 0.2, 1e-2);
}

TEST(Classify, TheTumblingBiconcaveOfTheBoundaryIntegralTableTumbles) {
  const std::vector<double> theta = {.093, -.008, -.275, -.909, -1.009, -1.281, -1.910, -2.010};
  const std::vector<double> D_xy = {.611, .519, .165, .606, .518, .162, .606, .517};
  const Verdict verdict = classify(history(30, [&](double kt) {
    return State{interpolated(D_xy, kt), pi * interpolated(theta, kt), 0.1 * std::sin(kt / 2)};
  }));
  EXPECT_EQ(verdict.motion, Motion::tumbling);
  EXPECT_NEAR(verdict.evidence.n_theta, 2.08, 0.02);
  EXPECT_TRUE(verdict.certain);
}

TEST(Classify, TheSwingingBiconcaveOfTheBoundaryIntegralTableTankTreads) {
  const std::vector<double> theta = {.096, .023, -.022, .003, .075, .022, -.015, -.045};
  const std::vector<double> D_xy = {.673, .617, .484, .158, .543, .593, .500, .248};
  const Verdict verdict = classify(history(30, [&](double kt) {
    return State{interpolated(D_xy, kt), pi * interpolated(theta, kt), -pi * kt / 16};
  }));
  EXPECT_EQ(verdict.motion, Motion::tank_treading);
  EXPECT_NEAR(verdict.evidence.D_min, 0.158, 0.01);
}

/// `flips` turns of the shape by pi, kt = 6 each from kt = 3 on, then tank-treading.
History flips_then_tank_treading(int flips, double end) {
  const double until = 3 + 6 * flips;
  return history(end, [=](double kt) {
    if (kt < until) return State{0.4, -pi * std::max(kt - 3, 0.0) / 6, 0};
    const State after = swinging(kt - until, 0.4, 6);
    return State{0.4, after.theta - pi * flips, after.psi};
  });
}

TEST(Classify, OneFlipThenTankTreadingIsATransitionHoweverLongItTankTreads) {
  for (double end : {16.0, 30.0, 60.0})
    EXPECT_EQ(classify(flips_then_tank_treading(1, end)).motion, Motion::transition) << end;
}

TEST(Classify, TwoFlipsThenTankTreadingIsATransition) {
  EXPECT_EQ(classify(flips_then_tank_treading(2, 60)).motion, Motion::transition);
}

TEST(Classify, APassageThroughZeroIsATransitionWhicheverBranchThetaTook) {
  for (double branch : {-0.5, 0.5}) {
    const Verdict verdict = classify(history(30, [&](double kt) {
      const double D_xy = std::abs(kt - 12) / 20;  // round at kt = 12, where the axes change places
      return State{D_xy, kt < 12 ? 0 : branch * pi, -pi * kt / 10};
    }));
    EXPECT_EQ(verdict.motion, Motion::transition);
    EXPECT_FALSE(verdict.certain);
  }
}

TEST(Classify, APassageThroughZeroBetweenTwoRecordsIsSeen) {
  // Q jumps across 0: both records are 0.3 away from it, the segment between them is not.
  const Verdict verdict = classify(history(30, [](double kt) {
    return State{0.3, kt < 12.05 ? 0.0 : -0.499 * pi, -pi * kt / 10};
  }));
  EXPECT_LT(verdict.evidence.D_min, 0.01);
  EXPECT_EQ(verdict.motion, Motion::transition);
}

TEST(Classify, ShapeAndMembraneTurningByEqualPartsIsATransition) {
  const Verdict verdict = classify(history(30, [](double kt) { return State{0.4, -0.2 * kt, -0.2 * kt}; }));
  EXPECT_EQ(verdict.motion, Motion::transition);
  EXPECT_NEAR(verdict.evidence.r, 0.5, 1e-12);
  EXPECT_NEAR(verdict.evidence.margin, 0.25, 1e-12);
}

TEST(Classify, LessThanOneHalfTurnIsUndecided) {
  EXPECT_EQ(classify({}).motion, Motion::undecided);
  EXPECT_EQ(classify(history(2, [](double kt) { return swinging(kt); })).motion, Motion::undecided);
  const Verdict verdict = classify(history(10, [](double kt) { return swinging(kt); }));
  EXPECT_EQ(verdict.motion, Motion::undecided);
  EXPECT_FALSE(verdict.certain);
}

TEST(Classify, TurningBeforeTheStartIsForgottenDoesNotCount) {
  const Verdict verdict = classify(history(15, [](double kt) {
    return State{0.4, kt < 3 ? -pi * kt : -3 * pi, kt < 3 ? 0 : -pi * (kt - 3) / 10};
  }));
  EXPECT_EQ(verdict.motion, Motion::tank_treading);
}

TEST(Classify, OneHalfTurnIsCertainOnlyFarFromTheRoundShape) {
  const auto steady = [](double D_xy, double end) {
    return classify(
        history(end, [=](double kt) {  // well deformed at first: the later value is an approach to 0
          return State{kt < 4 ? 0.5 : D_xy, 0.1, -pi * kt / 8};
        }));
  };
  EXPECT_TRUE(steady(0.11, 12).certain);
  EXPECT_FALSE(steady(0.08, 12).certain);
  EXPECT_TRUE(steady(0.08, 20).certain);
}

TEST(Classify, MarginIsTheDistanceToTheNearerThreshold) {
  const auto margin = [](double D_xy, double share) {
    return classify(history(30,
                            [=](double kt) {
                              return State{D_xy, -share * kt / 2, -(1 - share) * kt / 2};
                            }))
        .evidence.margin;
  };
  EXPECT_NEAR(margin(0.5, 0.1), 0.15, 1e-12);
  EXPECT_NEAR(margin(0.5, 0.95), 0.2, 1e-12);
  EXPECT_NEAR(margin(0.16, 0), 0.10, 1e-12);
}

TEST(Classify, AHistoryThatIsNotFiniteIsUndecided) {
  const Verdict verdict = classify(history(30, [](double kt) {
    return State{0.3, kt > 20 ? std::nan("") : 0.1, -kt};
  }));
  EXPECT_EQ(verdict.motion, Motion::undecided);
}

}  // namespace
}  // namespace capstan
