// Crossings of a row, and the limits of the boundary in them.
#include "runner/boundary/location.hpp"

#include <gmock/gmock.h>

namespace capstan {
namespace {

constexpr bool kConfirmed = true, kNotConfirmed = false;

/// A point whose score is `score`, with the error 0.02.
RowPoint point(double value, double score, bool is_confirmed) {
  const Motion motion = score >= 0.06    ? Motion::tumbling
                        : score <= -0.06 ? Motion::tank_treading
                                         : Motion::transition;
  return {value, true, motion, is_confirmed, score > 0 ? 1. : 0., std::abs(score), 0.02};
}

TEST(Crossings, AreNoneWhereAllPointsHaveOneLabel) {
  EXPECT_THAT(find_crossings({point(1, 0.2, kConfirmed), point(2, 0.3, kNotConfirmed)}),
              ::testing::IsEmpty());
}

TEST(Crossings, JoinAllThatLiesBetweenTwoPointsThatHaveAClass) {
  const auto found =
      find_crossings({point(1, 0.3, kConfirmed), point(2, 0.07, kNotConfirmed), point(3, 0.02, kNotConfirmed),
                      point(4, -0.02, kNotConfirmed), point(5, -0.3, kConfirmed)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].from, Motion::tumbling);
  EXPECT_EQ(found[0].to, Motion::tank_treading);
  EXPECT_EQ(found[0].begin, (Bracket{1, 2}));
  EXPECT_EQ(found[0].end, (Bracket{3, 4}));
  EXPECT_EQ(found[0].passage, (Bracket{2, 3}));
}

TEST(Crossings, ReachToTheEndOfTheRowWhereNoPointHasAClass) {
  const auto found = find_crossings({point(1, 0.3, kConfirmed), point(2, 0.05, kNotConfirmed)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].to, Motion::transition);
  EXPECT_FALSE(found[0].passage.has_value());
}

TEST(Crossings, EncloseAllChangesOfSignAmongPointsThatAreNotConfirmed) {
  const auto found = find_crossings({point(1, 0.3, kConfirmed), point(2, -0.01, kNotConfirmed),
                                     point(3, 0.01, kNotConfirmed), point(4, -0.3, kConfirmed)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].passage, (Bracket{0, 3}));
}

TEST(Location, ValueIsWhereTheScorePassesThroughZero) {
  const std::vector<RowPoint> points = {point(1, 0.3, kConfirmed), point(4, -0.3, kConfirmed)};
  EXPECT_NEAR(*locate(points, find_crossings(points)[0]).value, 2, 1e-12);  // linear in the logarithm
}

TEST(Location, LimitsAreWhereTheErrorNoLongerReachesZero) {
  const std::vector<RowPoint> points = {point(1, 0.3, kConfirmed), point(2, 0.01, kNotConfirmed),
                                        point(2.1, -0.01, kNotConfirmed), point(4, -0.3, kConfirmed)};
  const Location at = locate(points, find_crossings(points)[0]);
  EXPECT_GT(*at.low, 1);
  EXPECT_LT(*at.low, 2);
  EXPECT_GT(*at.high, 2.1);
  EXPECT_LT(*at.high, 4);
}

TEST(Location, HasNoLimitsWhereTheErrorsAreUnknown) {
  std::vector<RowPoint> points = {point(1, 0.3, kNotConfirmed), point(4, -0.3, kNotConfirmed)};
  for (RowPoint& each : points) each.error = std::numeric_limits<double>::quiet_NaN();
  const Location at = locate(points, find_crossings(points)[0]);
  EXPECT_TRUE(at.value.has_value());
  EXPECT_FALSE(at.low.has_value());
  EXPECT_FALSE(at.high.has_value());
}

TEST(Location, OfATransitionThatReachesTheEndOfTheRowIsBoundedOnOneSide) {
  const std::vector<RowPoint> points = {point(1, 0.3, kConfirmed), point(2, 0.05, kNotConfirmed),
                                        point(4, 0.01, kNotConfirmed)};
  const Location at = locate(points, find_crossings(points)[0]);
  EXPECT_FALSE(at.value.has_value());
  EXPECT_GT(*at.low, 2);
  EXPECT_FALSE(at.high.has_value());
  EXPECT_EQ(at.band_begin, 1);
  EXPECT_FALSE(at.band_end.has_value());
  EXPECT_EQ(at.confirmed_below, 1);
  EXPECT_FALSE(at.confirmed_above.has_value());
}

}  // namespace
}  // namespace capstan
