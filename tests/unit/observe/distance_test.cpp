#include "solver/observe/distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace capstan {
namespace {

using std::numbers::pi;

struct ShapeAt {
  double D_xy, theta, psi;
};

History history(double end, const std::function<ShapeAt(double)>& at, double every = 0.1) {
  History records;
  for (int n = 0; n * every <= end + 1e-9; ++n) {
    Record& record = records.emplace_back();
    const ShapeAt state = at(n * every);
    record["kt"] = n * every;
    record["D_xy"] = state.D_xy;
    record["theta"] = state.theta;
    record["psi"] = state.psi;
  }
  return records;
}

History steady(double D_xy, double theta, double end = 10) {
  return history(end, [=](double) { return ShapeAt{D_xy, theta, 0}; });
}

TEST(Distance, OfARunToItselfIsZero) {
  const History run = history(20, [](double kt) { return ShapeAt{0.3 + 0.1 * std::sin(kt), -kt / 2, 0}; });
  const Distance distance = distance_between(run, run);
  EXPECT_EQ(distance.Q, 0);
  EXPECT_EQ(distance.D_xy, 0);
  EXPECT_EQ(distance.theta, 0);
  EXPECT_EQ(distance.period, 0);
  EXPECT_EQ(distance.until_kt, 20);
}

TEST(Distance, OfQCombinesDeformationAndInclination) {
  const Distance deformed = distance_between(steady(0.3, 0.2), steady(0.25, 0.2));
  EXPECT_NEAR(deformed.Q, 0.05, 1e-12);
  EXPECT_NEAR(deformed.D_xy, 0.05, 1e-12);
  EXPECT_NEAR(deformed.theta, 0, 1e-12);
  const Distance inclined = distance_between(steady(0.3, 0.2), steady(0.3, 0.3));
  EXPECT_NEAR(inclined.Q, 2 * 0.3 * std::sin(0.1), 1e-12);
  EXPECT_NEAR(inclined.D_xy, 0, 1e-12);
  EXPECT_NEAR(inclined.theta, 0.1, 1e-12);
}

TEST(Distance, OfAnglesDoesNotCountHalfTurns) {
  EXPECT_NEAR(distance_between(steady(0.3, 0.2), steady(0.3, 0.2 - 3 * pi)).Q, 0, 1e-12);
  EXPECT_NEAR(distance_between(steady(0.3, 0.2), steady(0.3, 0.2 - 3 * pi)).theta, 0, 1e-12);
  EXPECT_NEAR(distance_between(steady(0.3, 0), steady(0.3, pi / 2)).Q, 0.6, 1e-12);
}

TEST(Distance, HasNoAngleWhereTheSectionIsRound) {
  EXPECT_TRUE(std::isnan(distance_between(steady(0.04, 0), steady(0.04, 1)).theta));
  EXPECT_NEAR(distance_between(steady(0.06, 0), steady(0.06, 1)).theta, 1, 1e-12);
}

TEST(Distance, OfPeriodsIsRelativeAndCountsBothKindsOfTurns) {
  const auto turning = [](double rate, double share) {
    return history(30, [=](double kt) { return ShapeAt{0.3, -share * rate * kt, -(1 - share) * rate * kt}; });
  };
  EXPECT_NEAR(distance_between(turning(1.02, 1), turning(1, 1)).period, 0.02, 1e-9);
  EXPECT_NEAR(distance_between(turning(1.02, 0), turning(1, 0)).period, 0.02, 1e-9);
  EXPECT_TRUE(std::isnan(distance_between(turning(0.05, 1), turning(0.05, 1)).period));
}

TEST(Distance, UsesTheTimesThatBothRunsHave) {
  const auto bending = [](double kt) { return ShapeAt{kt < 5.05 ? 0.2 : 0.4, 0, 0}; };
  EXPECT_EQ(distance_between(history(10, bending), steady(0.2, 0, 5)).Q, 0);
  EXPECT_NEAR(distance_between(history(10, bending), steady(0.2, 0, 5)).until_kt, 5, 1e-12);
  EXPECT_NEAR(distance_between(history(10, bending, 0.5), steady(0.2, 0, 10)).Q, 0.2, 1e-12);
  EXPECT_EQ(distance_between({}, steady(0.2, 0)).until_kt, 0);
}

}  // namespace
}  // namespace capstan
