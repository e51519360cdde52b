// The label of whole runs, and their early end.
#include <gtest/gtest.h>

#include "solver/simulation/simulation.hpp"
#include "tests/support/memory_output.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

struct Ended {
  Stop stop;
  double kt, last_recorded_kt;
  Verdict verdict;
};

/// In Stokes flow with 162 nodes.
/// \param parameters of the case, JSON without its braces   \param until, outputs  their JSON
Ended run(const std::string& parameters, const std::string& until, const std::string& outputs = "{}") {
  Simulation simulation(testing::parsed_case(R"({"fluid": "stokes", )" + parameters + R"(, "until": )" +
                                             until + R"(, "outputs": )" + outputs +
                                             R"(, "fidelity": {"nodes": 162}})"));
  testing::MemoryOutput output;
  const Stop stop = simulation.run(output).stop;
  return {stop, simulation.kt(), output.records.back()["kt"], simulation.verdict()};
}

const std::string kTumblingSpheroid = R"("shape": "oblate", "aspect": 0.5, "Ca": 0.0094, "E_b": 0.005)";

TEST(EarlyEnd, ASteadySphereStopsAsSteadyAndTankTreads) {
  const Ended sphere = run(R"("Ca": 0.05)", R"({"kt": 30, "classified": true})");
  EXPECT_EQ(sphere.stop, Stop::steady);
  EXPECT_LT(sphere.kt, 9);
  EXPECT_EQ(sphere.verdict.motion, Motion::tank_treading);
}

TEST(EarlyEnd, IsRecordedAndDoesNotDependOnTheOutputs) {
  const std::string until = R"({"kt": 30, "classified": true})";
  const Ended often = run(R"("Ca": 0.05)", until, R"({"history_every": 0.1})");
  const Ended seldom = run(R"("Ca": 0.05)", until, R"({"history_every": 1})");
  EXPECT_EQ(often.stop, seldom.stop);
  EXPECT_EQ(often.kt, seldom.kt);
  EXPECT_EQ(often.last_recorded_kt, often.kt);
  EXPECT_EQ(seldom.last_recorded_kt, seldom.kt);
}

TEST(EarlyEnd, ASteadySphereRunsToItsEndWithoutUntilClassified) {
  const Ended sphere = run(R"("Ca": 0.05)", R"({"kt": 10})");
  EXPECT_EQ(sphere.stop, Stop::reached_end);
  EXPECT_EQ(sphere.last_recorded_kt, 10);
}

TEST(EarlyEnd, ATumblingSpheroidEndsClassified) {
  const Ended early = run(kTumblingSpheroid, R"({"kt": 30, "classified": true})");
  EXPECT_EQ(early.stop, Stop::classified);
  EXPECT_LT(early.kt, 15);
  EXPECT_EQ(early.verdict.motion, Motion::tumbling);
}

TEST(LaterEnd, ARunThatIsUndecidedAtKtEndsWhenItHasALabel) {
  const Ended late = run(kTumblingSpheroid, R"({"kt": 5, "classified": true})");
  EXPECT_EQ(late.stop, Stop::classified);
  EXPECT_GT(late.kt, 5);
  EXPECT_LT(late.kt, 15);
  EXPECT_EQ(late.last_recorded_kt, late.kt);
  EXPECT_NE(late.verdict.motion, Motion::undecided);
}

TEST(LaterEnd, ARunThatStaysUndecidedEndsAtItsLatestTime) {
  const Ended undecided = run(kTumblingSpheroid, R"({"kt": 5, "classified": true, "at_most": 6.03})");
  EXPECT_EQ(undecided.stop, Stop::reached_end);
  EXPECT_EQ(undecided.last_recorded_kt, 6.03);
  EXPECT_EQ(undecided.verdict.motion, Motion::undecided);
}

TEST(LaterEnd, ARunWithoutClassifiedEndsAtKtThoughItIsUndecided) {
  EXPECT_EQ(run(kTumblingSpheroid, R"({"kt": 5})").last_recorded_kt, 5);
}

TEST(Label, OfASphereWithAViscousInteriorIsTankTreading) {
  EXPECT_EQ(run(R"("Ca": 0.1, "V": 20)", R"({"kt": 28})").verdict.motion, Motion::tank_treading);
}

TEST(Label, OfANearlySphericalProlateIsTankTreading) {
  const Ended prolate = run(R"("shape": "prolate", "aspect": 1.07, "Ca": 0.0094)", R"({"kt": 25})");
  EXPECT_EQ(prolate.verdict.motion, Motion::tank_treading);
}

TEST(Label, AndItsEvidenceDoNotDependOnTheOutputs) {
  const std::string cell =
      R"("shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "Ca": 0.25, "V": 4)";
  const Evidence often = run(cell, R"({"kt": 17})", R"({"history_every": 0.1})").verdict.evidence;
  for (const char* outputs : {R"({"history_every": 1})", R"({"history_every": 0.33, "shapes_every": 0.7})"}) {
    const Evidence seldom = run(cell, R"({"kt": 17})", outputs).verdict.evidence;
    EXPECT_EQ(often.D_min, seldom.D_min) << outputs;
    EXPECT_EQ(often.r, seldom.r) << outputs;
    EXPECT_EQ(often.margin, seldom.margin) << outputs;
  }
}

TEST(Label, OfARunThatIsTooShortIsUndecidedAndSaysSo) {
  const Verdict verdict = run(R"("Ca": 0.05)", R"({"kt": 4})").verdict;
  EXPECT_EQ(verdict.motion, Motion::undecided);
  EXPECT_NE(verdict.explanation.find("half-turns were seen from kt = 3 on, at least 1 is needed"),
            std::string::npos)
      << verdict.explanation;
}

}  // namespace
}  // namespace capstan
