// Labels of recorded runs of kt = 60 or more (tests/reference/motions) and of their beginnings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "solver/observe/classify.hpp"
#include "tests/support/source_directory.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;

MotionSamples recorded(const std::string& name) {
  std::ifstream file(source_directory() / "tests/reference/motions" / (std::string(name) + ".csv"));
  EXPECT_TRUE(file) << name;
  MotionSamples samples;
  for (std::string line; std::getline(file, line);) {
    MotionSample sample;
    char comma;
    if (std::istringstream(line) >> sample.kt >> comma >> sample.D_xy >> comma >> sample.theta >> comma >>
        sample.psi)
      samples.push_back(sample);
  }
  return samples;
}

/// \param end  kt up to which the run is judged
Verdict verdict_at(const MotionSamples& samples, double end) {
  MotionSamples part;
  for (const MotionSample& sample : samples)
    if (sample.kt <= end + 1e-9) part.push_back(sample);
  return classify(part);
}

/// The first verdict that is certain.
std::optional<Verdict> early_end(const MotionSamples& samples) {
  for (const MotionSample& sample : samples)
    if (Verdict verdict = verdict_at(samples, sample.kt); verdict.certain) return verdict;
  return std::nullopt;
}

constexpr const char* kNearlyRound[] = {"sphere_V15_Ca0.1", "sphere_V50_Ca0.2", "sphere_V100_Ca0.4",
                                        "prolate1.07_V1_Ca0.0094"};

TEST(RecordedMotions, NearlySphericalCapsulesTankTreadAfterThreeHalfTurnsWithASmallDMin) {
  for (const char* name : kNearlyRound)
    for (double end = 28; end <= 60; end += 4)
      EXPECT_EQ(verdict_at(recorded(name), end).motion, Motion::tank_treading) << name << " to kt = " << end;
}

TEST(RecordedMotions, TheFirstCertainLabelIsThatOfTheLongRun) {
  for (const char* name :
       {"biconcave_V8_Ca0.9", "biconcave_V8_Ca1", "biconcave_V6_Ca0.9", "biconcave_V4_Ca0.25",
        "biconcave_V2_Ca0.2", "oblate0.5_V15_Ca0.6", "sphere_V1_Ca0.2", "sphere_V15_Ca0.1",
        "sphere_V50_Ca0.2", "sphere_V100_Ca0.4", "prolate1.07_V1_Ca0.0094"}) {
    const MotionSamples samples = recorded(name);
    const auto verdict = early_end(samples);
    if (verdict) {
      EXPECT_EQ(verdict->motion, classify(samples).motion) << name;
    }
  }
}

// D_min of their half-turns: .184, .117, .074, .050, .045 and .179, .105, .055, .029, .027.
TEST(RecordedMotions, ARedCellWhoseDMinDecreasesWithEachHalfTurnIsNotCertain) {
  for (const char* name : {"biconcave_V8_Ca0.9", "biconcave_V8_Ca1"})
    for (double end = 4; end <= 60; ++end)
      EXPECT_FALSE(verdict_at(recorded(name), end).certain) << name << ' ' << end;
}

TEST(RecordedMotions, ACapsuleThatTumblesSevenTimesBeforeItTankTreadsIsNotCertain) {
  const MotionSamples samples = recorded("oblate0.5_V15_Ca0.6");
  EXPECT_EQ(verdict_at(samples, 60).motion, Motion::tumbling);
  EXPECT_EQ(verdict_at(samples, 100).motion, Motion::tank_treading);
  EXPECT_EQ(early_end(samples), std::nullopt);
}

TEST(RecordedMotions, ARedCellWithALargeDMinIsCertain) {
  const auto verdict = early_end(recorded("biconcave_V4_Ca0.25"));
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->motion, Motion::tumbling);
  EXPECT_LT(verdict->evidence.turns, 2.5);
}

TEST(RecordedMotions, RunsNearAThresholdHaveASmallMargin) {
  EXPECT_LT(verdict_at(recorded("biconcave_V2_Ca0.2"), 30).evidence.margin, 0.01);  // D_min .058
  EXPECT_LT(verdict_at(recorded("biconcave_V6_Ca0.9"), 24).evidence.margin,
            0.05);  // tumbles, then D_min .011
  EXPECT_LT(verdict_at(recorded("biconcave_V6_Ca0.9"), 90).evidence.margin, 0.05);  // after both kinds
  EXPECT_LT(verdict_at(recorded("sphere_V100_Ca0.4"), 16).evidence.margin,
            0.05);  // only one half-turn: not settled
  EXPECT_GT(verdict_at(recorded("biconcave_V4_Ca0.25"), 30).evidence.margin, 0.06);
}

TEST(RecordedMotions, ASteadySphereIsSteadyAndItsExplanationSaysSo) {
  const auto verdict = early_end(recorded("sphere_V1_Ca0.2"));
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict->steady);
  EXPECT_THAT(verdict->explanation, HasSubstr("steady"));
}

}  // namespace
}  // namespace capstan
