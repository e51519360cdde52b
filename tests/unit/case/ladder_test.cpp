#include "solver/case/ladder.hpp"

#include <gtest/gtest.h>

#include "solver/case/grid_size.hpp"
#include "solver/case/limits.hpp"
#include "solver/case/run_cost.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using testing::parsed_case;

Case stokes(const std::string& fidelity) {
  return parsed_case(R"({"Ca": 0.1, "fluid": "stokes", "fidelity": )" + fidelity + "}");
}
Case lattice(const std::string& fidelity) {
  return parsed_case(R"({"Ca": 0.1, "fluid": "quasisteady", "fidelity": )" + fidelity + "}");
}

TEST(Ladder, APresetIsARung) {
  EXPECT_EQ(companion_of(stokes(R"("fast")"))->fidelity.nodes, 162);
  EXPECT_EQ(companion_of(stokes(R"("standard")"))->fidelity.nodes, 642);
  EXPECT_EQ(companion_of(stokes(R"("fine")"))->fidelity.nodes, 2562);
  const auto companion = companion_of(lattice(R"("fast")"));
  EXPECT_EQ(companion->fidelity.nodes, 162);
  EXPECT_EQ(companion->fidelity.dx, 0.4);
}

TEST(Ladder, ACompanionIsTheCaseThatItsOwnFileWouldGive) {
  Case companion = *companion_of(lattice(R"("standard")"));
  companion.outputs.shapes_every = 1;
  Case fast = lattice(R"("fast")");
  fast.companion = false;
  EXPECT_EQ(companion, fast);
  companion = *companion_of(lattice(R"("fast")"));
  companion.outputs.shapes_every = 1;
  Case coarse = lattice(R"({"dx": 0.4, "nodes": 162})");
  coarse.companion = false;
  EXPECT_EQ(companion, coarse);
}

TEST(Ladder, EndsAtItsCoarsestRung) {
  EXPECT_FALSE(coarser(stokes(R"({"nodes": 42})")));
  EXPECT_FALSE(coarser(stokes(R"({"nodes": 92})")));
  EXPECT_FALSE(coarser(lattice(R"({"nodes": 162, "dx": 0.4})")));
}

TEST(Ladder, HasTwoRungsBetweenASpacingAndItsHalf) {
  const Case fast = stokes(R"("fast")");
  EXPECT_EQ(rung_below(fast)->fidelity.nodes, 362);
  EXPECT_EQ(rung_above(fast)->fidelity.nodes, 1442);
  EXPECT_EQ(rung_below(*rung_below(fast))->fidelity.nodes, coarser(fast)->fidelity.nodes);
  EXPECT_FALSE(rung_above(stokes(R"("fine")")));
  EXPECT_FALSE(rung_below(stokes(R"({"nodes": 42})")));
}

TEST(Ladder, OfLatticesHasSpacingsThatFitTheBox) {
  std::optional<Case> rung = lattice(R"({"nodes": 162, "dx": 0.4})");
  for (const int cells : {48, 64, 96, 128, 192, 256}) {
    rung = rung_above(*rung);
    ASSERT_TRUE(rung);
    EXPECT_EQ(std::lround(12.8 / rung->fidelity.dx), cells);
  }
  EXPECT_FALSE(rung_above(*rung));
}

TEST(Ladder, HasNoRungThatDoesNotFitTheBox) {
  EXPECT_FALSE(coarser(lattice(R"({"preset": "fast", "box": 11.2})")));  // 28 spacings of 0.4
  EXPECT_TRUE(coarser(lattice(R"({"preset": "fast", "box": 9.6})")));
}

TEST(Ladder, IsNotThatOfTheTransientLatticeOrThePapersScheme) {
  EXPECT_FALSE(has_ladder(parsed_case(R"({"Ca": 0.1, "fluid": "transient"})")));
  EXPECT_FALSE(has_ladder(lattice(R"("paper")")));
}

TEST(Companion, IsSwitchedOffByTheCase) {
  EXPECT_FALSE(companion_of(parsed_case(R"({"Ca": 0.1, "companion": false})")));
}

TEST(Companion, CostsAtMostAThirdOfTheRun) {
  for (const Case& c : {stokes(R"("standard")"), stokes(R"("fine")"), lattice(R"("standard")")})
    EXPECT_LE(case_cost(c), 1.34 * run_cost(c));
}

TEST(ExpectedRung, IsFinerForASmallerErrorAndForARedCell) {
  const auto nodes_for = [](const std::string& keys) {
    return parsed_case(R"({"Ca": 0.1, "fluid": "stokes", )" + keys + "}").fidelity.nodes;
  };
  EXPECT_EQ(nodes_for(R"("fidelity": {"error": 0.5})"), 92);  // below 42 nodes there is no rung
  EXPECT_LT(nodes_for(R"("fidelity": {"error": 0.05})"), nodes_for(R"("fidelity": {"error": 0.005})"));
  EXPECT_LT(nodes_for(R"("fidelity": {"error": 0.005})"), nodes_for(R"("fidelity": {"error": 0.001})"));
  EXPECT_LT(nodes_for(R"("fidelity": {"error": 0.01})"),
            nodes_for(R"("shape": "biconcave", "fidelity": {"error": 0.01})"));
}

TEST(ExpectedRung, FitsTheBoxAndHasARungBelowThatDoes) {
  for (const char* box : {"6.4", "8.5333333333333333", "9.6"})
    for (const char* error : {"0.001", "0.02", "0.2"}) {
      const Case c = lattice(R"({"error": )" + std::string(error) + R"(, "box": )" + box + "}");
      EXPECT_EQ(issue_of_grid(c), "") << box << ", " << error;
      ASSERT_TRUE(rung_below(c)) << box << ", " << error;
      EXPECT_EQ(limits_exceeded(*rung_below(c)).size(), 0u) << box << ", " << error;
    }
}

TEST(Climb, BeginsAtACoarserRungWhichHasOneBelow) {
  const Case c = stokes(R"({"error": 0.003})"), first = first_of_climb(c);
  EXPECT_LT(first.fidelity.nodes, c.fidelity.nodes);
  EXPECT_TRUE(rung_below(first));
  EXPECT_EQ(first_of_climb(stokes(R"({"error": 0.5})")).fidelity.nodes, 92);
}

TEST(Climb, OfAMembraneThatWrinklesBeginsWhereTheMeshShowsIt) {
  const auto nodes_for = [](const std::string& keys) {
    return first_of_climb(
               parsed_case(R"({"V": 1, "fluid": "stokes", "fidelity": {"error": 0.1}, )" + keys + "}"))
        .fidelity.nodes;
  };
  EXPECT_EQ(nodes_for(R"("Ca": 0.02)"), 1442);
  EXPECT_EQ(nodes_for(R"("Ca": 0.02, "E_b": 0.01)"), 92);
  EXPECT_EQ(nodes_for(R"("Ca": 0.1)"), 92) << "which is not compressed";
}

TEST(UsualRuns, ForAnErrorAskedForAreRungsOneAfterTheOtherUpToTheExpectedOne) {
  const Case c = stokes(R"({"error": 0.003})");
  const std::vector<Case> runs = usual_runs(c);
  ASSERT_GE(runs.size(), 3u);
  EXPECT_EQ(runs.front(), rung_below(first_of_climb(c)));
  for (std::size_t i = 1; i < runs.size(); ++i) EXPECT_EQ(rung_above(runs[i - 1]), runs[i]);
  EXPECT_EQ(runs.back(), single_run(c));
  double seconds = 0;
  for (const Case& run : runs) seconds += run_cost(run);
  EXPECT_DOUBLE_EQ(case_cost(c), seconds);
}

TEST(UsualRuns, WithoutAnErrorAskedForAreTheCompanionAndTheRun) {
  const Case fast = stokes(R"("fast")");
  EXPECT_EQ(usual_runs(fast), (std::vector<Case>{*companion_of(fast), single_run(fast)}));
}

TEST(ErrorAskedFor, ReplacesTheSettingsOfTheResolution) {
  const auto issues_of = [](const std::string& fidelity) {
    return parse_case(
               nlohmann::json::parse(R"({"Ca": 0.1, "fluid": "quasisteady", "fidelity": )" + fidelity + "}"))
        .issues.size();
  };
  EXPECT_EQ(issues_of(R"({"error": 0.01})"), 0u);
  EXPECT_EQ(issues_of(R"({"error": 0.01, "box": 9.6, "symmetry": "none"})"), 0u);
  EXPECT_EQ(issues_of(R"({"error": 0.01, "dx": 0.2, "nodes": 642, "preset": "fast"})"), 3u);
  EXPECT_EQ(issues_of(R"({"error": 0})"), 1u);
  EXPECT_EQ(issues_of(R"({"error": 0.0009})"), 1u) << "smaller than any that is stated";
  EXPECT_EQ(issues_of(R"({"error": 0.01, "box": 10})"), 2u);
}

TEST(ErrorAskedFor, ReadsBackFromTheCanonicalForm) {
  const Case c = stokes(R"({"error": 0.01})");
  EXPECT_EQ(to_json(c)["fidelity"]["error"], 0.01);
  EXPECT_FALSE(to_json(c)["fidelity"].contains("nodes"));
  EXPECT_EQ(parse_case(to_json(c)).value, c);
}

}  // namespace
}  // namespace capstan
