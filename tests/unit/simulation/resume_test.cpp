// A run that is continued from a checkpoint equals the uninterrupted run to the last bit.
#include <gtest/gtest.h>

#include <algorithm>

#include "solver/simulation/simulation.hpp"
#include "tests/support/every_model.hpp"
#include "tests/support/memory_output.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using testing::case_of_model;
using testing::MemoryOutput;
using testing::parsed_case;

void expect_equal(const RunStatistics& a, const RunStatistics& b) {
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.flow_iterations, b.flow_iterations);
  EXPECT_EQ(a.worst_flow_error, b.worst_flow_error);
  EXPECT_EQ(a.volume_drift, b.volume_drift);
  EXPECT_EQ(a.area_drift, b.area_drift);
}

/// Continues the run from each of its checkpoints and compares with the uninterrupted run.
void expect_resumed_equals_uninterrupted(const Case& c) {
  MemoryOutput whole;
  whole.checkpoint_every = c.outputs.checkpoint_every;
  Simulation uninterrupted(c);
  EXPECT_EQ(uninterrupted.run(whole).stop, Stop::reached_end);
  ASSERT_GE(whole.checkpoints.size(), 3u);
  for (const StateArchive& checkpoint : whole.checkpoints) {
    MemoryOutput rest;
    Simulation resumed(c);
    resumed.load(checkpoint);
    EXPECT_EQ(resumed.run(rest).stop, Stop::reached_end);
    EXPECT_EQ(resumed.history(), whole.records);
    EXPECT_EQ(resumed.samples(), uninterrupted.samples());
    EXPECT_EQ(resumed.surface().worst(), uninterrupted.surface().worst());
    EXPECT_TRUE(std::equal(rest.shapes.rbegin(), rest.shapes.rend(), whole.shapes.rbegin()));
    EXPECT_EQ(rest.shapes.size() + std::size_t(checkpoint.number("frames")), whole.shapes.size());
    expect_equal(resumed.statistics(), uninterrupted.statistics());
  }
}

TEST(Resume, QuasisteadySphereEqualsTheUninterruptedRun) {
  expect_resumed_equals_uninterrupted(parsed_case(R"({
    "Ca": 0.1, "until": {"kt": 0.8}, "outputs": {"shapes_every": 0.15, "checkpoint_every": 1},
    "fidelity": {"dx": 0.4, "nodes": 162, "kdt": 0.08}})"));
}

TEST(Resume, BiconcaveCapsuleWithBendingAndViscosityRatioEqualsTheUninterruptedRun) {
  expect_resumed_equals_uninterrupted(parsed_case(R"({
    "shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "V": 4, "Ca": 0.4,
    "until": {"kt": 0.8}, "outputs": {"shapes_every": 0.15, "checkpoint_every": 1},
    "fidelity": {"dx": 0.4, "nodes": 162, "kdt": 0.08}})"));
}

TEST(Resume, UnsteadyFlowWithViscosityRatioEqualsTheUninterruptedRun) {
  expect_resumed_equals_uninterrupted(parsed_case(R"({
    "Ca": 0.1, "V": 2, "Re": 1, "fluid": "unsteady", "until": {"kt": 0.7},
    "outputs": {"shapes_every": 0.15, "checkpoint_every": 1},
    "fidelity": {"dx": 0.4, "nodes": 162, "kdt": 0.08}})"));
}

TEST(Resume, TransientFlowEqualsTheUninterruptedRun) {
  expect_resumed_equals_uninterrupted(parsed_case(R"({
    "Ca": 0.1, "V": 2, "fluid": "transient", "until": {"kt": 0.05},
    "outputs": {"history_every": 0.01, "shapes_every": 0.013, "checkpoint_every": 50},
    "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162}})"));
}

TEST(Resume, TransientFlowInDoublePrecisionEqualsTheUninterruptedRun) {
  expect_resumed_equals_uninterrupted(parsed_case(R"({
    "Ca": 0.1, "V": 2, "fluid": "transient", "until": {"kt": 0.05},
    "outputs": {"history_every": 0.01, "shapes_every": 0.013, "checkpoint_every": 51},
    "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "precision": "double"}})"));
}

TEST(Resume, StokesFlowWithErrorControlledStepsEqualsTheUninterruptedRun) {
  expect_resumed_equals_uninterrupted(parsed_case(R"({
    "shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "V": 4, "Ca": 0.4, "fluid": "stokes",
    "until": {"kt": 2.5}, "outputs": {"shapes_every": 0.15, "checkpoint_every": 1}, "fidelity": {"nodes": 162}})"));
}

// A single cycle meets the tolerance here, so a wrong initial flow after the restart would change the result.
TEST(Resume, PapersSchemeEqualsTheUninterruptedRun) {
  expect_resumed_equals_uninterrupted(parsed_case(R"({
    "Ca": 0.1, "until": {"kt": 0.8}, "outputs": {"shapes_every": 0.15, "checkpoint_every": 1},
    "fidelity": {"preset": "paper", "dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.08, "tolerance": 0.01}})"));
}

TEST(Resume, AnEarlyEndHasTheSameTimeAndEvidence) {
  const Case c = parsed_case(R"({"Ca": 0.05, "fluid": "stokes", "until": {"kt": 30, "classified": true},
    "fidelity": {"nodes": 162}})");
  MemoryOutput whole;
  whole.checkpoint_every = 15;
  Simulation uninterrupted(c);
  EXPECT_EQ(uninterrupted.run(whole).stop, Stop::steady);
  ASSERT_GE(whole.checkpoints.size(), 2u);
  for (const StateArchive& checkpoint : whole.checkpoints) {
    MemoryOutput rest;
    Simulation resumed(c);
    resumed.load(checkpoint);
    EXPECT_EQ(resumed.run(rest).stop, Stop::steady);
    EXPECT_EQ(resumed.history(), uninterrupted.history());
    EXPECT_EQ(resumed.verdict().evidence.margin, uninterrupted.verdict().evidence.margin);
  }
}

TEST(Resume, ALaterEndHasTheSameHistory) {
  const Case c =
      parsed_case(R"({"shape": "oblate", "aspect": 0.5, "Ca": 0.0094, "E_b": 0.005, "fluid": "stokes",
    "until": {"kt": 5, "classified": true}, "outputs": {"history_every": 0.3}, "fidelity": {"nodes": 162}})");
  MemoryOutput whole;
  whole.checkpoint_every = 40;
  Simulation uninterrupted(c);
  EXPECT_EQ(uninterrupted.run(whole).stop, Stop::classified);
  ASSERT_GE(whole.checkpoints.size(), 2u);
  EXPECT_GT(whole.checkpoints.back().number("kt"), 5);
  MemoryOutput rest;
  Simulation resumed(c);
  resumed.load(whole.checkpoints.back());
  EXPECT_EQ(resumed.run(rest).stop, Stop::classified);
  EXPECT_EQ(resumed.history(), uninterrupted.history());
}

class ProlongedRun : public ::testing::TestWithParam<testing::Model> {
 protected:
  static Case case_to(double kt, double history_every = 0.007) {
    return case_of_model(GetParam(), kt, {.history_every = history_every, .shapes_every = 0.05});
  }
};

/// The first end is no multiple of the intervals of records and shapes.
TEST_P(ProlongedRun, EqualsTheLongerRunToTheLastBit) {
  for (double end : {0.11, 0.12, 0.2}) {
    MemoryOutput first, rest, whole;
    Simulation shorter(case_to(end)), prolonged(case_to(0.2)), longer(case_to(0.2));
    EXPECT_EQ(shorter.run(first).stop, Stop::reached_end);
    EXPECT_EQ(longer.run(whole).stop, Stop::reached_end);
    prolonged.load(first.last);
    EXPECT_EQ(prolonged.run(rest).stop, Stop::reached_end);
    EXPECT_EQ(prolonged.history(), longer.history());
    EXPECT_EQ(prolonged.samples(), longer.samples());
    EXPECT_EQ(prolonged.surface().worst(), longer.surface().worst());
    EXPECT_TRUE(std::equal(rest.shapes.rbegin(), rest.shapes.rend(), whole.shapes.rbegin()));
    expect_equal(prolonged.statistics(), longer.statistics());
  }
}

TEST_P(ProlongedRun, BeginsWithTheHistoryOfTheShorterRun) {
  MemoryOutput first, whole;
  Simulation(case_to(0.12, 0.03)).run(first);
  Simulation(case_to(0.2, 0.03)).run(whole);
  ASSERT_EQ(first.records.size(), 5u);
  EXPECT_TRUE(std::equal(first.records.begin(), first.records.end(), whole.records.begin()));
}

INSTANTIATE_TEST_SUITE_P(Models, ProlongedRun, testing::kEveryModel, testing::name_of_model);

TEST(ProlongedCase, ThatEndedWithItsLabelEqualsTheLongerRun) {
  const auto case_to = [](double kt, bool classified) {
    Case c = parsed_case(R"({"Ca": 0.05, "fluid": "stokes", "until": {"kt": 30, "classified": true},
      "fidelity": {"nodes": 162}})");
    c.until = {.kt = kt, .classified = classified, .at_most = classified ? 3 * kt : 0};
    return c;
  };
  MemoryOutput first, rest, whole;
  Simulation shorter(case_to(30, true)), prolonged(case_to(12, false)), longer(case_to(12, false));
  EXPECT_EQ(shorter.run(first).stop, Stop::steady);
  ASSERT_LT(shorter.history().back()["kt"], 12);
  prolonged.load(first.last);
  prolonged.run(rest);
  longer.run(whole);
  EXPECT_EQ(prolonged.history(), longer.history());
  EXPECT_EQ(prolonged.verdict().evidence.margin, longer.verdict().evidence.margin);
}

TEST(Resume, AnInterruptionWritesACheckpointOfItsStep) {
  const Case c = parsed_case(R"({"Ca": 0.1, "until": {"kt": 0.4}, "outputs": {"checkpoint_every": 100},
    "fidelity": {"dx": 0.4, "nodes": 162, "kdt": 0.08}})");
  MemoryOutput stopped;
  stopped.interruption_wanted = true;
  Simulation simulation(c);
  EXPECT_EQ(simulation.run(stopped).stop, Stop::interrupted);
  EXPECT_EQ(simulation.statistics().steps, 1);
  ASSERT_EQ(stopped.checkpoints.size(), 1u);

  MemoryOutput whole, rest;
  Simulation uninterrupted(c), resumed(c);
  uninterrupted.run(whole);
  resumed.load(stopped.checkpoints.front());
  resumed.run(rest);
  EXPECT_EQ(resumed.history(), whole.records);
}

}  // namespace
}  // namespace capstan
