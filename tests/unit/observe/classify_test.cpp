#include "solver/observe/classify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace capstan {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A sample without its time.
struct State {
  double D_xy, theta, psi;
};

MotionSamples samples(double end, const std::function<State(double)>& at) {
  MotionSamples all;
  for (int n = 0; n <= std::lround(end / 0.1); ++n) {
    const double kt = 0.1 * n;
    const State state = at(kt);
    all.push_back({kt, state.D_xy, state.theta, state.psi});
  }
  return all;
}

/// Piecewise linear curve through values at kt = 2, 6, 10, ..
double interpolated(const std::vector<double>& values, double kt) {
  const double place = std::clamp((kt - 2) / 4, 0.0, static_cast<double>(values.size()) - 1.001);
  const auto n = static_cast<size_t>(place);
  return values[n] + (place - static_cast<double>(n)) * (values[n + 1] - values[n]);
}

State rigid_spheroid(double kt, double D_xy, double aspect) {  // Jeffery: turns by pi in kt = pi (a/b + b/a)
  const double t = kt / (aspect + 1 / aspect);
  return {D_xy, std::atan2(-aspect * std::sin(t), std::cos(t)) - 2 * pi * std::floor((t + pi) / (2 * pi)), 0};
}

/// Swinging: the capsule tank-treads and its shape oscillates twice in each turn of the membrane.
State swinging(double kt, double D_xy = 0.4, double half_turn = 8) {
  const double phase = pi * kt / half_turn;
  return {D_xy + 0.1 * std::cos(2 * phase), 0.1 * std::sin(2 * phase), -phase};
}

TEST(Classify, ARigidSpheroidTumbles) {
  const Verdict verdict = classify(samples(30, [](double kt) { return rigid_spheroid(kt, 1.0 / 3, 0.5); }));
  EXPECT_EQ(verdict.motion, Motion::tumbling);
  EXPECT_NEAR(verdict.evidence.r, 1, 1e-12);
  EXPECT_NEAR(verdict.evidence.D_min, 1.0 / 3, 0.01);
  EXPECT_NEAR(verdict.evidence.theta_range, pi, 0.15);
  EXPECT_TRUE(verdict.certain);
}

TEST(Classify, ASteadySphereWithATurningMembraneTankTreads) {
  const Verdict verdict = classify(samples(30, [](double kt) {
    return State{0.27 * (1 - std::exp(-3 * kt)), pi * (0.17 + 0.08 * std::exp(-3 * kt)), -kt / 2};
  }));
  EXPECT_EQ(verdict.motion, Motion::tank_treading);
  EXPECT_NEAR(verdict.evidence.n_psi, 27 / (2 * pi), 1e-2);
  EXPECT_NEAR(verdict.evidence.theta_range, 0, 1e-3);
  EXPECT_TRUE(verdict.certain);
}

TEST(Classify, ASteadyShapeOfSmallDeformationIsNoPassageThroughZero) {
  for (double D_xy : {0.08, 0.03, 0.001}) {
    const Verdict verdict = classify(samples(20, [&](double kt) { return State{D_xy, 0.7, -kt / 2}; }));
    EXPECT_EQ(verdict.motion, Motion::tank_treading) << D_xy;
  }
}

TEST(Classify, ARigidSpheroidOfAspectNineTenthsTumbles) {
  const Verdict verdict = classify(samples(30, [](double kt) { return rigid_spheroid(kt, 0.0526, 0.9); }));
  EXPECT_EQ(verdict.motion, Motion::tumbling);
}

TEST(Classify, SwingingIsTankTreading) {
  const Verdict verdict = classify(samples(30, [](double kt) { return swinging(kt); }));
  EXPECT_EQ(verdict.motion, Motion::tank_treading);
  EXPECT_NEAR(verdict.evidence.theta_range, 0.2, 1e-2);
}

TEST(Classify, ARecordedTumblingRedCellTumbles) {
  const std::vector<double> theta = {.093, -.008, -.275, -.909, -1.009, -1.281, -1.910, -2.010};
  const std::vector<double> D_xy = {.611, .519, .165, .606, .518, .162, .606, .517};
  const Verdict verdict = classify(samples(30, [&](double kt) {
    return State{interpolated(D_xy, kt), pi * interpolated(theta, kt), 0.1 * std::sin(kt / 2)};
  }));
  EXPECT_EQ(verdict.motion, Motion::tumbling);
  EXPECT_NEAR(verdict.evidence.n_theta, 2.08, 0.02);
  EXPECT_TRUE(verdict.certain);
}

TEST(Classify, ARecordedSwingingRedCellTankTreads) {
  const std::vector<double> theta = {.096, .023, -.022, .003, .075, .022, -.015, -.045};
  const std::vector<double> D_xy = {.673, .617, .484, .158, .543, .593, .500, .248};
  const Verdict verdict = classify(samples(30, [&](double kt) {
    return State{interpolated(D_xy, kt), pi * interpolated(theta, kt), -pi * kt / 16};
  }));
  EXPECT_EQ(verdict.motion, Motion::tank_treading);
  EXPECT_NEAR(verdict.evidence.D_min, 0.158, 0.01);
}

/// From kt = 3 on: `flips` half-turns of the shape, each of length kt = 6, then tank-treading.
MotionSamples flips_then_tank_treading(int flips, double end) {
  const double until = 3 + 6 * flips;
  return samples(end, [=](double kt) {
    if (kt < until) return State{0.4, -pi * std::max(kt - 3, 0.0) / 6, 0};
    const State after = swinging(kt - until, 0.4, 6);
    return State{0.4, after.theta - pi * flips, after.psi};
  });
}

TEST(Classify, TumblingFollowedByTankTreadingIsATransitionUntilTheMotionHasSettled) {
  for (int flips : {1, 2}) {
    const double flipped = 3 + 6 * flips;
    EXPECT_EQ(classify(flips_then_tank_treading(flips, flipped + 6.1)).motion, Motion::transition) << flips;
    EXPECT_EQ(classify(flips_then_tank_treading(flips, flipped + 16)).motion, Motion::transition) << flips;
    EXPECT_EQ(classify(flips_then_tank_treading(flips, flipped + 19)).motion, Motion::tank_treading) << flips;
    EXPECT_EQ(classify(flips_then_tank_treading(flips, 60)).motion, Motion::tank_treading) << flips;
  }
}

TEST(Classify, ASettledMotionIsJudgedByItsLastThreeHalfTurnsAndMentionsEarlierMotion) {
  const Verdict verdict = classify(flips_then_tank_treading(1, 60));
  EXPECT_NEAR(verdict.evidence.r, 0, 0.01);
  EXPECT_NEAR(verdict.evidence.n_theta, 1, 0.1);
  EXPECT_THAT(verdict.explanation, HasSubstr("The last 8 half-turns were of the membrane. Before them"));
}

TEST(Classify, AlternatingKindsAreATransition) {
  const Verdict verdict = classify(samples(90, [](double kt) {  // two half-turns of each kind in turn
    const double turned = kt / 8, rest = std::fmod(turned, 4), pairs = 2 * std::floor(turned / 4);
    const double D_xy = 0.4 + 0.1 * std::cos(2 * pi * turned);
    return State{D_xy, -pi * (pairs + std::min(rest, 2.0)), -pi * (pairs + std::max(rest - 2, 0.0))};
  }));
  EXPECT_EQ(verdict.motion, Motion::transition);
  EXPECT_FALSE(verdict.certain);
}

TEST(Classify, APassageThroughZeroIsATransitionForEitherBranchOfTheta) {
  for (double branch : {-0.5, 0.5}) {
    const Verdict verdict = classify(samples(30, [&](double kt) {
      const double D_xy = std::abs(kt - 12) / 20;  // circular at kt = 12, where major and minor axis exchange
      return State{D_xy, kt < 12 ? 0 : branch * pi, -pi * kt / 10};
    }));
    EXPECT_EQ(verdict.motion, Motion::transition);
    EXPECT_FALSE(verdict.certain);
  }
}

TEST(Classify, APassageThroughZeroBetweenTwoSamplesIsDetected) {
  // Q jumps across 0: both samples are more than 0.2 away from it, the segment between them is not.
  const Verdict verdict = classify(samples(30, [](double kt) {
    return State{0.25 + 0.04 * std::sin(kt), kt < 12.05 ? 0.0 : -0.499 * pi, -pi * kt / 10};
  }));
  EXPECT_LT(verdict.evidence.D_min, 0.01);
  EXPECT_EQ(verdict.motion, Motion::transition);
}

TEST(Classify, AfterThreeHalfTurnsOfOneKindASmallDMinDoesNotCount) {
  const auto nearly_round = [](double end) {  // D_xy between 0.01 and 0.41
    return classify(samples(end, [](double kt) {
      return State{0.21 + 0.2 * std::cos(2 * pi * kt / 8), 0.3, -pi * kt / 8};
    }));
  };
  EXPECT_EQ(nearly_round(3 + 23.5).motion, Motion::transition);
  EXPECT_EQ(nearly_round(3 + 24.5).motion, Motion::tank_treading);
  EXPECT_NEAR(nearly_round(60).evidence.margin, 0.01, 0.001);
  EXPECT_FALSE(nearly_round(60).certain);
}

TEST(Classify, EqualRotationOfShapeAndMembraneIsATransition) {
  const Verdict verdict = classify(samples(30, [](double kt) { return State{0.4, -0.2 * kt, -0.2 * kt}; }));
  EXPECT_EQ(verdict.motion, Motion::transition);
  EXPECT_NEAR(verdict.evidence.r, 0.5, 1e-12);
  EXPECT_NEAR(verdict.evidence.margin, 0.4, 1e-3);
}

TEST(Classify, LessThanOneHalfTurnIsUndecided) {
  EXPECT_EQ(classify({}).motion, Motion::undecided);
  EXPECT_EQ(classify(samples(2, [](double kt) { return swinging(kt); })).motion, Motion::undecided);
  const Verdict verdict = classify(samples(10, [](double kt) { return swinging(kt); }));
  EXPECT_EQ(verdict.motion, Motion::undecided);
  EXPECT_FALSE(verdict.certain);
}

TEST(Classify, HalfTurnsBeforeKtThreeDoNotCount) {
  const Verdict verdict = classify(samples(15, [](double kt) {
    return State{0.4, kt < 3 ? -pi * kt : -3 * pi, kt < 3 ? 0 : -pi * (kt - 3) / 10};
  }));
  EXPECT_EQ(verdict.motion, Motion::tank_treading);
}

/// Tank-treading with the smallest D_xy in the middle of each half-turn.
MotionSamples approaching(const std::vector<double>& D_min, double end) {
  return samples(end, [=](double kt) {
    const double turned = std::max(kt - 3, 0.0) / 8;
    const double nearest = D_min[std::min(size_t(turned), D_min.size() - 1)];
    return State{nearest + (0.5 - nearest) * std::pow(std::cos(pi * turned), 2), 0.1, -pi * turned};
  });
}

TEST(Classify, OneHalfTurnIsCertainOnlyIfQStaysFarFromZero) {
  EXPECT_TRUE(classify(approaching({0.3}, 12)).certain);
  EXPECT_FALSE(classify(approaching({0.2}, 12)).certain);
  EXPECT_TRUE(classify(approaching({0.2}, 20)).certain);
}

TEST(Classify, TheLabelIsNotCertainWhileQApproachesZero) {
  EXPECT_TRUE(classify(approaching({0.15, 0.14}, 20)).certain);
  for (double end = 11; end <= 27; end += 0.5)
    EXPECT_FALSE(classify(approaching({0.17, 0.1, 0.06}, end)).certain) << end;
  EXPECT_FALSE(classify(approaching({0.17, 0.1, 0.05, 0.03}, 40)).certain);
}

TEST(Classify, ASteadyShapeIsCertainBeforeItsFirstHalfTurn) {
  const auto steady = [](double end) {
    return classify(samples(end, [](double kt) {
      return State{0.27 * (1 - std::exp(-2 * kt)), 0.5, -kt / 2};
    }));
  };
  EXPECT_FALSE(steady(5).steady);
  EXPECT_TRUE(steady(8).steady);
  EXPECT_TRUE(steady(8).certain);
  EXPECT_EQ(steady(8).motion, Motion::tank_treading);
  EXPECT_NEAR(steady(8).evidence.margin, 0.27, 0.001);
}

TEST(Classify, AConstantShapeWithAMembraneAtRestIsNotSteady) {
  const Verdict verdict = classify(samples(60, [](double) { return State{0.5, 0.1, 0}; }));
  EXPECT_FALSE(verdict.steady);
  EXPECT_EQ(verdict.motion, Motion::undecided);
}

double margin(double end, const std::function<State(double)>& at) {
  return classify(samples(end, at)).evidence.margin;
}

/// With shares of the shape near the threshold, the error that turns theta over the run by what is missing.
TEST(Margin, OfTumblingAndTankTreadingIsTheErrorThatReachesTheNearerThreshold) {
  const auto after_two_half_turns = [](double D_xy, double share) {
    return margin(17, [=](double kt) {
      const double swing = 0.02 * std::cos(pi * (kt - 3));  // so that it is not steady
      return State{D_xy + swing, -share * kt / 2, -(1 - share) * kt / 2};
    });
  };
  const double half_turns = 14 / (2 * pi), D_min = 0.48;
  EXPECT_NEAR(after_two_half_turns(0.5, 0.2), D_min * std::sin(pi * half_turns * 0.05), 1e-4);
  EXPECT_NEAR(after_two_half_turns(0.5, 0.77), D_min * std::sin(pi * half_turns * 0.02), 1e-4);
  EXPECT_NEAR(classify(approaching({0.08}, 20)).evidence.margin, 0.02, 0.001);
}

/// A motion whose Q is moved by less than the margin keeps its label; one whose Q is moved by more in the
/// direction of the nearest other label does not.
TEST(Margin, IsTheErrorOfQThatTheLabelTolerates) {
  const auto tank_treading = [](double offset) {  // Q is moved by -offset along x
    return classify(samples(20, [=](double kt) {
      const double turned = pi * std::max(kt - 3, 0.) / 8, D = 0.1 + 0.3 * std::pow(std::cos(turned), 2);
      return State{D - offset, 0, -turned};
    }));
  };
  const Verdict exact = tank_treading(0);
  EXPECT_EQ(exact.motion, Motion::tank_treading);
  EXPECT_EQ(tank_treading(0.95 * exact.evidence.margin).motion, Motion::tank_treading);
  EXPECT_EQ(tank_treading(1.05 * exact.evidence.margin).motion, Motion::transition);
}

TEST(Margin, OfATransitionIsSmallNearTheThresholdOfItsReason) {
  const auto of_share = [](double share) {
    return margin(30, [=](double kt) { return State{0.4, -share * kt / 2, -(1 - share) * kt / 2}; });
  };
  const double half_turns = 27 / (2 * pi);
  EXPECT_NEAR(of_share(0.5), 0.4, 1e-3);
  EXPECT_NEAR(of_share(0.26), 0.4 * std::sin(pi * half_turns * 0.01), 1e-4);
  EXPECT_NEAR(of_share(0.74), 0.4 * std::sin(pi * half_turns * 0.01), 1e-4);
}

TEST(Margin, OfATransitionIsSmallBeforeTheMotionSettles) {
  EXPECT_LE(classify(flips_then_tank_treading(1, 9 + 13)).evidence.margin, 0.15);
  const Verdict near_round = classify(approaching({0.03}, 20));
  EXPECT_EQ(near_round.motion, Motion::transition);
  EXPECT_LE(near_round.evidence.margin, 0.011);
}

TEST(Margin, IsBetweenZeroAndTheDeformation) {
  for (double end : {2.0, 10.0, 20.0, 45.0, 80.0})
    for (const MotionSamples& motion :
         {flips_then_tank_treading(2, end), approaching({0.01}, end),
          samples(end, [](double kt) { return rigid_spheroid(kt, 1. / 3, 0.5); })}) {
      EXPECT_GE(classify(motion).evidence.margin, 0);
      EXPECT_LE(classify(motion).evidence.margin, 1);
    }
}

TEST(Explanation, OfUndecidedGivesTheNumberOfHalfTurnsSeenAndNeeded) {
  const auto sphere_to = [](double end) {
    return classify(samples(end, [](double kt) { return State{0.1 + 0.01 * kt, 0.5, -kt / 2}; })).explanation;
  };
  EXPECT_EQ(sphere_to(2),
            "0 half-turns were seen: they are counted from kt = 3 on. At least 1 is needed: ask for a "
            "later until.kt.");
  EXPECT_EQ(sphere_to(6),
            "0.48 half-turns were seen from kt = 3 on, at least 1 is needed: at this rate the first one "
            "ends at about kt = 10. The same case with a later end goes on from here.");
  EXPECT_THAT(classify({}).explanation, StartsWith("0 half-turns were seen"));
}

TEST(Explanation, OfATransitionGivesItsReasonAndWhatItLacksToSettle) {
  EXPECT_EQ(classify(approaching({0.03}, 20)).explanation,
            "The section came near to round: D_min = 0.03 is less than 0.06. It would settle with 3 "
            "half-turns of one "
            "kind in a row; seen so far: 2.1 half-turns, the last 2 half-turns of one kind.");
}

TEST(Classify, SamplesThatAreNotFiniteAreUndecided) {
  const Verdict verdict = classify(samples(30, [](double kt) {
    return State{0.3, kt > 20 ? std::nan("") : 0.1, -kt};
  }));
  EXPECT_EQ(verdict.motion, Motion::undecided);
}

}  // namespace
}  // namespace capstan
