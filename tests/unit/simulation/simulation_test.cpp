#include "solver/simulation/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "solver/case/left_out.hpp"
#include "solver/output/result.hpp"
#include "tests/support/memory_output.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MemoryOutput;
using testing::parsed_case;
using ::testing::StartsWith;

/// Four steps of a small run.
Case small_case() {
  return parsed_case(R"({"Ca": 0.1, "until": {"kt": 0.32},
    "outputs": {"history_every": 0.08, "shapes_every": 0.16},
    "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.08}})");
}

Case stiff_case(double kdt) {
  Case c = parsed_case(R"({"shape": "biconcave", "law": "skalak", "C": 5, "Ca": 0.05, "until": {"kt": 20},
    "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "stepper": "ab2"}})");
  c.fidelity.kdt = kdt;
  return c;
}

std::vector<double> times_of(const History& history) {
  std::vector<double> all;
  for (const Record& record : history) all.push_back(record["kt"]);
  return all;
}

TEST(Simulation, RecordsTheMultiplesOfTheIntervalFromStartToEnd) {
  MemoryOutput output;
  Simulation simulation(small_case());
  EXPECT_EQ(simulation.run(output).stop, Stop::reached_end);
  EXPECT_THAT(times_of(output.records), ElementsAre(0, 0.08, 0.16, 0.24, 0.32));
  EXPECT_THAT(output.shape_times(), ElementsAre(0, 0.16, 0.32));
  EXPECT_EQ(simulation.statistics().steps, 4);
}

TEST(Simulation, SphereElongatesTowardsTheAxisOfExtension) {
  MemoryOutput output;
  Simulation(small_case()).run(output);
  EXPECT_LT(output.records.front()["D_xy"], 1e-12);
  EXPECT_GT(output.records.back()["D_xy"], 0.1);
  EXPECT_NEAR(output.records.back()["theta"], std::numbers::pi / 4, 0.1);
}

TEST(Simulation, EveryFlowIterationIsRecordedOnce) {
  MemoryOutput output;
  Simulation simulation(small_case());
  simulation.run(output);
  double recorded = 0;
  for (const Record& record : output.records) recorded += record["iterations"];
  EXPECT_EQ(recorded, double(simulation.statistics().flow_iterations));
}

TEST(Simulation, ThatDivergesGivesTimeAndReasonAndKeepsItsHistory) {
  for (double kdt : {0.2, 0.5, 1.0}) {
    MemoryOutput output;
    Simulation simulation(stiff_case(kdt));
    const Outcome outcome = simulation.run(output);
    EXPECT_EQ(outcome.stop, Stop::diverged) << kdt;
    EXPECT_THAT(outcome.message, StartsWith("at kt = "));
    EXPECT_GE(output.records.size(), 1u);
    EXPECT_EQ(output.records, simulation.history());
    EXPECT_LT(simulation.history().back()["kt"], 20);
  }
}

TEST(Simulation, WithManyRejectedStepsStopsAlsoOnASmoothSurface) {
  const Case thin = parsed_case(
      R"({"Ca": 1, "V": 0.05, "fluid": "stokes", "until": {"kt": 3}, "fidelity": {"nodes": 162}})");
  MemoryOutput output;
  Simulation simulation(thin);
  const Outcome outcome = simulation.run(output);
  EXPECT_EQ(outcome.stop, Stop::diverged);
  EXPECT_THAT(outcome.message, HasSubstr("steps become ever shorter"));
  EXPECT_THAT(outcome.message, HasSubstr("take the fluid quasisteady"));
}

TEST(Simulation, OfAStiffMembraneShortensAStepWhoseFlowIsNotFinite) {
  MemoryOutput output;
  Simulation simulation(parsed_case(
      R"({"Ca": 0.00417, "V": 1, "law": "skalak", "C": 525.3, "shape": "oblate", "aspect": 0.3378,
          "fluid": "quasisteady", "Re": 0.01, "until": {"kt": 0.001}, "fidelity": "fast"})"));
  const Outcome outcome = simulation.run(output);
  EXPECT_EQ(outcome.stop, Stop::reached_end) << outcome.message;
}

TEST(Simulation, ThatBreaksDownWritesItsLastValidStateAndTheInvalidOneEvenWithoutShapes) {
  Case c = stiff_case(0.2);
  c.outputs.shapes_every = 0;
  MemoryOutput output;
  Simulation simulation(c);
  EXPECT_EQ(simulation.run(output).stop, Stop::diverged);
  ASSERT_EQ(output.shapes.size(), 2u);
  const auto& [sound, wrong] = std::tie(output.shapes[0], output.shapes[1]);
  EXPECT_EQ(sound.frame, 0);
  EXPECT_EQ(wrong.frame, 1);
  EXPECT_EQ(sound.kt, output.records.back()["kt"]);
  EXPECT_DOUBLE_EQ(wrong.kt - sound.kt, 0.2);
  EXPECT_NE(sound.positions, wrong.positions);
}

TEST(Simulation, ThatEndsEarlyWritesTheShapeOfItsLastRecord) {
  MemoryOutput output;
  Simulation simulation(parsed_case(R"({"Ca": 0.05, "fluid": "stokes", "fidelity": {"nodes": 162},
    "until": {"kt": 30, "classified": true}, "outputs": {"shapes_every": 2.35}})"));
  EXPECT_NE(simulation.run(output).stop, Stop::reached_end);
  ASSERT_LT(output.records.back()["kt"], 20);
  EXPECT_EQ(output.shapes.back().kt, output.records.back()["kt"]);
}

TEST(Simulation, FlowThatDoesNotConvergeIsAnOutcome) {
  Case c = small_case();
  c.fidelity.tolerance = 1e-30;
  MemoryOutput output;
  const Outcome outcome = Simulation(c).run(output);
  EXPECT_EQ(outcome.stop, Stop::not_converged);
  EXPECT_THAT(outcome.message, HasSubstr("at kt = 0: the multigrid cycles did not converge"));
}

nlohmann::ordered_json result_of(const Case& c, const Choices& choices = {}) {
  MemoryOutput output;
  Simulation simulation(c);
  const Outcome outcome = simulation.run(output);
  return result_json(c, choices, simulation, outcome, 1.25);
}

TEST(Result, NamesTheModelsAndTheOmittedPhysics) {
  const auto plain = result_of(small_case());
  EXPECT_EQ(plain["stop"], "reached_end");
  EXPECT_EQ(plain["trust"]["fluid"], "quasisteady");
  EXPECT_EQ(plain["trust"]["bending"], "none");
  EXPECT_EQ(plain["trust"]["left_out"].get<std::vector<std::string>>(), left_out(small_case()));
  EXPECT_EQ(plain["trust"]["left_out"].size(), 5u);

  const auto full = result_of(parsed_case(R"({"Ca": 0.1, "V": 2, "E_b": 0.01, "bending": "helfrich_literal",
    "fluid": "transient", "until": {"kt": 0.001}, "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162}})"));
  EXPECT_EQ(full["trust"]["fluid"], "transient");
  EXPECT_EQ(full["trust"]["bending"], "helfrich_literal");
  EXPECT_TRUE(full["trust"]["left_out"].empty());
}

TEST(Result, HoldsTheCaseAndTheChosenSettings) {
  const Choices choices = {{"fluid", "auto", "quasisteady", "because"}};
  const auto result = result_of(small_case(), choices);
  EXPECT_EQ(result["case"], to_json(small_case()));
  EXPECT_EQ(result["choices"], to_json(choices));
  EXPECT_EQ(result["choices"][0]["asked"], "auto");
}

TEST(Result, HoldsTheLastRecordTheCostAndTheReasonOfAFailure) {
  const auto result = result_of(stiff_case(1));
  EXPECT_EQ(result["stop"], "diverged");
  EXPECT_THAT(result["message"].get<std::string>(), StartsWith("at kt = "));
  EXPECT_TRUE(result["motion"].is_null());
  EXPECT_EQ(result["evidence"]["margin"], 0);
  EXPECT_THAT(result["explanation"].get<std::string>(), HasSubstr("no motion"));
  EXPECT_TRUE(result["final"].contains("D_xy"));
  EXPECT_EQ(result["cost"]["seconds"], 1.25);
}

TEST(Result, WarnsOfAQuasisteadyFlowAtAReynoldsNumberThatIsNotSmall) {
  Case c = small_case();
  c.fidelity.box = 12.8;
  EXPECT_TRUE(result_of(c)["trust"]["warnings"].empty());
  c.Re = 0.2;
  EXPECT_THAT(result_of(c)["trust"]["warnings"][0].get<std::string>(), HasSubstr("quasi-steady"));
}

TEST(Result, HasAFlowErrorOfAtLeastTheRoundingError) {
  for (const char* keys : {R"("fluid": "stokes", "fidelity": {"nodes": 42})", R"("fluid": "transient",
    "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 42})"}) {
    const auto result =
        result_of(parsed_case(R"({"Ca": 0.1, "until": {"kt": 0.01}, )" + std::string(keys) + "}"));
    EXPECT_EQ(result["trust"]["worst_flow_error"], 1e-6) << keys;
  }
}

TEST(Result, OfASmoothSurfaceHasNoWarning) {
  const auto surface = result_of(small_case())["trust"]["surface"];
  EXPECT_LT(surface["largest_dihedral"], 30);  // 162 vertices
  EXPECT_GT(surface["smallest_angle"], 30);
  EXPECT_EQ(surface["folded_edges"], 0);
  EXPECT_TRUE(surface["folded_from"].is_null());
}

// Measured: folded from kt = 3.4 on, triangles lie on each other from 7.5 on.
TEST(Result, OfACrumpledSphereWarnsAndHasNoLabel) {
  const auto result = result_of(parsed_case(R"({"Ca": 0.6426, "Re": 0.02579, "fluid": "quasisteady",
    "fidelity": {"preset": "fast", "box": 12.8}, "until": {"kt": 20}, "outputs": {"shapes_every": 0}})"));
  const auto surface = result["trust"]["surface"];
  EXPECT_GT(surface["largest_dihedral"], 135);
  EXPECT_GT(surface["folded_edges"], 0.005);
  EXPECT_NEAR(surface["lost_from"], 16.3, 3);
  EXPECT_THAT(result["trust"]["warnings"].at(0).get<std::string>(),
              AllOf(HasSubstr("not smooth on this mesh"), HasSubstr("E_b"), HasSubstr("more nodes")));
  EXPECT_EQ(result["motion"], "undecided");
  EXPECT_EQ(result["evidence"]["margin"], 0);
  EXPECT_THAT(result["explanation"].get<std::string>(), HasSubstr("cannot represent the surface"));
}

}  // namespace
}  // namespace capstan
