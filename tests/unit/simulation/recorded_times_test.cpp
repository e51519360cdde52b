// Records and shapes lie exactly at the requested times, for every flow model and stepper.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/simulation/simulation.hpp"
#include "tests/support/every_model.hpp"
#include "tests/support/memory_output.hpp"

namespace capstan {
namespace {

using testing::case_of_model;
using ::testing::Each;
using ::testing::ElementsAre;
using testing::MemoryOutput;
using testing::Model;

class RecordedTimes : public ::testing::TestWithParam<Model> {
 protected:
  static Case case_with(double kt, const Outputs& outputs) { return case_of_model(GetParam(), kt, outputs); }

  MemoryOutput run(const Case& c) {
    MemoryOutput output;
    Simulation simulation(c);
    EXPECT_EQ(simulation.run(output).stop, Stop::reached_end);
    samples_ = simulation.samples();
    return output;
  }

  MotionSamples samples_;  ///< of the last run
};

std::vector<double> times(const History& history) {
  std::vector<double> all;
  for (const Record& record : history) all.push_back(record["kt"]);
  return all;
}

TEST_P(RecordedTimes, AreTheMultiplesOfTheIntervalAndTheEnd) {
  const MemoryOutput output = run(case_with(0.14, {.history_every = 0.05, .shapes_every = 0.03}));
  EXPECT_THAT(times(output.records), ElementsAre(0, 0.05, 0.1, 0.14));
  EXPECT_THAT(output.shape_times(), ElementsAre(0, 0.03, 0.06, 0.09, 0.12, 0.14));
}

TEST_P(RecordedTimes, IncludeTheEndOnceIfRoundingErrorsSeparateItFromAMultiple) {
  for (int count : {3, 7, 49})
    EXPECT_EQ(run(case_with(0.14, {.history_every = 0.14 / count})).records.size(), count + 1u);
}

TEST_P(RecordedTimes, DoNotChangeTheMotion) {
  const MemoryOutput rare = run(case_with(0.12, {.history_every = 0.06, .shapes_every = 0}));
  const MotionSamples samples = samples_;
  const MemoryOutput often = run(case_with(0.12, {.history_every = 0.02, .shapes_every = 0.05}));
  EXPECT_EQ(samples_, samples);
  EXPECT_EQ(often.records[3]["D_xy"], rare.records[1]["D_xy"]);
  EXPECT_EQ(often.records.back()["psi"], rare.records.back()["psi"]);
}

TEST_P(RecordedTimes, EqualTheEndOfARunToThatTime) {
  const Record passed = run(case_with(0.2, {.history_every = 0.15})).records[1];
  const Record last = run(case_with(0.15, {.history_every = 0.15})).records.back();
  EXPECT_EQ(passed, last);
}

TEST_P(RecordedTimes, DoNotChangeTheSamplesWhichSpanTheRun) {
  run(case_with(0.5, {.history_every = 0.5, .shapes_every = 0}));
  ASSERT_GE(samples_.size(), 6u);
  EXPECT_EQ(samples_.front().kt, 0);
  EXPECT_GT(samples_.back().kt, 0.5 - kSampleInterval);
  for (std::size_t n = 1; n < samples_.size(); ++n) EXPECT_GT(samples_[n].kt, samples_[n - 1].kt);
}

INSTANTIATE_TEST_SUITE_P(Models, RecordedTimes, testing::kEveryModel, testing::name_of_model);

}  // namespace
}  // namespace capstan
