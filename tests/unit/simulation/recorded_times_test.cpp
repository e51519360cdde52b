// Records and shapes lie exactly at the requested times, for every flow model and stepper.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/simulation/simulation.hpp"
#include "tests/support/memory_output.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using testing::MemoryOutput;
using testing::parsed_case;

struct Model {
  const char* name;
  const char* knobs;  ///< JSON of fluid and fidelity
};

class RecordedTimes : public ::testing::TestWithParam<Model> {
 protected:
  Case case_with(double kt, const Outputs& outputs) const {
    Case c = parsed_case(std::string(R"({"Ca": 0.1, "V": 2, )") + GetParam().knobs + "}");
    c.until.kt = kt;
    c.outputs = outputs;
    return c;
  }

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
  EXPECT_EQ(passed["kt"], last["kt"]);
  EXPECT_NEAR(passed["D_xy"], last["D_xy"], 1e-3 * last["D_xy"]);
  EXPECT_NEAR(passed["psi"], last["psi"], 5e-3 * std::abs(last["psi"]));
  EXPECT_NEAR(passed["volume"], last["volume"], 1e-4 * last["volume"]);
}

TEST_P(RecordedTimes, DoNotChangeTheSamplesWhichSpanTheRun) {
  run(case_with(0.5, {.history_every = 0.5, .shapes_every = 0}));
  ASSERT_GE(samples_.size(), 6u);
  EXPECT_EQ(samples_.front().kt, 0);
  EXPECT_GT(samples_.back().kt, 0.5 - kSampleInterval);
  for (std::size_t n = 1; n < samples_.size(); ++n) EXPECT_GT(samples_[n].kt, samples_[n - 1].kt);
}

INSTANTIATE_TEST_SUITE_P(
    Models, RecordedTimes,
    ::testing::Values(
        Model{"StokesRkc2", R"("fluid": "stokes", "fidelity": {"nodes": 162})"},
        Model{"StokesAb2", R"("fluid": "stokes", "fidelity": {"nodes": 162, "stepper": "ab2", "kdt": 0.02})"},
        Model{"LatticeAb2", R"("fluid": "quasisteady", "fidelity": {"dx": 0.4, "nodes": 162, "kdt": 0.03})"},
        Model{"LatticeRkc2",
              R"("fluid": "quasisteady", "fidelity": {"dx": 0.4, "nodes": 162, "stepper": "rkc2"})"},
        Model{"Unsteady",
              R"("fluid": "unsteady", "Re": 1, "fidelity": {"dx": 0.4, "nodes": 162, "kdt": 0.03})"},
        Model{"Transient", R"("fluid": "transient", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162})"},
        Model{"Paper", R"("fluid": "quasisteady",
                         "fidelity": {"preset": "paper", "dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.04})"}),
    [](const auto& model) { return std::string(model.param.name); });

}  // namespace
}  // namespace capstan
