#include "solver/case/scene_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "solver/case/case_warnings.hpp"
#include "solver/case/equal_accuracy.hpp"
#include "solver/case/left_out.hpp"
#include "solver/case/modelled.hpp"
#include "solver/case/run_cost.hpp"
#include "solver/case/run_size.hpp"
#include "tests/support/parsed_case.hpp"
#include "tests/support/source_directory.hpp"

namespace capstan {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

Case with(const std::string& keys) { return testing::parsed_case(R"({"Ca": 0.25)" + keys + "}"); }

const std::string kRedCell = R"(, "shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "V": 4)";

TEST(Modelled, NamesCapsuleMembraneFlowAndResolution) {
  EXPECT_THAT(modelled(with(kRedCell + R"(, "fidelity": "fast")")),
              ElementsAre("capsule: biconcave, inclined by pi/4 in the plane of shear",
                          "membrane: skalak, C = 5 (E_s = 2 G), 642 nodes; bending variational, spontaneous "
                          "curvature that of the initial shape at each vertex",
                          "fluids: the inner one has the larger viscosity",
                          "flow: stokes, by boundary integrals over the membrane",
                          "time: rkc2, steps chosen by their error"));
  const auto words = modelled(with(R"(, "shape": "oblate", "aspect": 0.5, "until": {"classified": true},
                         "fidelity": {"dx": 0.2, "nodes": 642, "box": 25.6, "stepper": "ab2"})"));
  EXPECT_THAT(words, Contains("capsule: oblate spheroid, b/a = 0.5, inclined by pi/4 in the plane of shear"));
  EXPECT_THAT(words, Contains(AllOf(StartsWith("flow: quasisteady"), HasSubstr("dx = 0.2"))));
  EXPECT_THAT(words, Contains(AllOf(StartsWith("walls:"), HasSubstr("25.6"))));
  EXPECT_THAT(words, Contains("time: ab2, equal steps"));
  EXPECT_THAT(words, Contains(StartsWith("end: as soon as")));
}

TEST(Modelled, HasTheSameWordsForOtherNumbersOfTheSameScene) {
  const std::string lattice =
      R"(, "shape": "biconcave", "fluid": "quasisteady", "fidelity": {"dx": 0.2, "nodes": 642, "stepper": "ab2"})";
  Case a = with(lattice + R"(, "V": 2, "Re": 0.01, "E_b": 0.1)");
  Case b = with(lattice + R"(, "V": 5, "Re": 0.05, "E_b": 0.2, "until": {"kt": 60})");
  b.Ca = 1;
  EXPECT_EQ(modelled(a), modelled(b));
  EXPECT_NE(modelled(a), modelled(with(lattice + R"(, "V": 0.5, "E_b": 0.1)")));
}

TEST(Modelled, ATimeStepIsGivenWhereStepsAreEqual) {
  const std::string lattice = R"(, "fluid": "quasisteady", "fidelity": {"dx": 0.2, "nodes": 642, )";
  EXPECT_EQ(equal_time_step(with(lattice + R"("kdt": 0.03})")), 0.03);
  EXPECT_FALSE(equal_time_step(with(lattice + R"("stepper": "rkc2"})")));
  // 0.04 Re dx²
  EXPECT_NEAR(equal_time_step(with(R"(, "fluid": "transient", "Re": 0.5, "fidelity": "fast")")).value(),
              0.04 * 0.5 * 0.04, 1e-12);
}

TEST(LeftOut, OfBoundaryIntegralsAreInertiaAndWalls) {
  const auto parts = left_out(with(kRedCell));
  EXPECT_THAT(parts, Contains(StartsWith("inertia of the fluid: Re = 0")));
  EXPECT_THAT(parts, Contains(StartsWith("walls:")));
  EXPECT_THAT(parts, Not(Contains(HasSubstr("E_b = 0;"))));
  EXPECT_THAT(parts, Not(Contains(HasSubstr("V = 1;"))));
}

TEST(LeftOut, OfAQuasisteadyFlowGrowsWithTheReynoldsNumber) {
  const auto parts_at = [](const std::string& Re) {
    return left_out(with(R"(, "fluid": "quasisteady", "Re": )" + Re));
  };
  EXPECT_THAT(parts_at("0.05"), Contains(HasSubstr("0.07 Re = 0.0035 ")));
  EXPECT_THAT(parts_at("0.02"), Contains(HasSubstr("0.07 Re = 0.0014 ")));
  EXPECT_THAT(left_out(with(R"(, "fluid": "unsteady", "Re": 0.5)")),
              Not(Contains(HasSubstr("time derivative"))));
}

TEST(LeftOut, MotionOutOfThePlaneIsNamedForCapsulesThatCanTilt) {
  EXPECT_THAT(left_out(with(kRedCell)), Contains(StartsWith("motion out of the plane of shear")));
  EXPECT_THAT(left_out(with("")), Not(Contains(HasSubstr("plane of shear: the capsule"))));
}

TEST(LeftOut, IsNothingWhereEverythingIsModelled) {
  EXPECT_THAT(left_out(with(R"(, "V": 2, "E_b": 0.01, "fluid": "transient", "fidelity": "fast")")),
              IsEmpty());
}

/// "studies/fig10" in a sentence.
std::vector<std::string> folders_in(const std::string& sentence) {
  static const std::regex folder("studies/[a-z_0-9]+");
  return {std::sregex_token_iterator(sentence.begin(), sentence.end(), folder), {}};
}

TEST(ScenePlan, EveryStudyThatItCitesIsThere) {
  std::size_t cited = 0;
  for (const char* keys : {R"(, "shape": "biconcave", "fluid": "stokes")",
                           R"(, "fluid": "quasisteady", "fidelity": {"box": 6.4})",
                           R"(, "fidelity": "paper")", R"(, "fluid": "unsteady", "V": 50)"}) {
    const ScenePlan plan = plan_of(with(keys));
    for (const auto& sentences : {plan.modelled, plan.left_out, plan.warnings, std::vector{plan.error}})
      for (const std::string& sentence : sentences)
        for (const std::string& folder : folders_in(sentence)) {
          EXPECT_TRUE(std::filesystem::exists(source_directory() / folder)) << sentence;
          ++cited;
        }
  }
  EXPECT_GT(cited, 8u);
}

TEST(ScenePlan, HasTheCostsOfTheRun) {
  const Case c = with(kRedCell);
  const ScenePlan plan = plan_of(c);
  EXPECT_EQ(plan.seconds, case_cost(c));
  EXPECT_EQ(plan.memory, run_memory(c));
  EXPECT_EQ(plan.disk, run_size(c));
  EXPECT_EQ(plan.left_out, left_out(c));
  EXPECT_EQ(plan.warnings, case_warnings(c));
}

TEST(ScenePlan, NamesTheCompanionFromWhichTheErrorIsEstimated) {
  const std::string fast = R"(, "fidelity": "fast")";
  EXPECT_THAT(plan_of(with(fast)).error, HasSubstr("a second one, with 162 nodes"));
  EXPECT_THAT(plan_of(with(fast + R"(, "companion": false)")).error, Not(HasSubstr("a second one")));
  EXPECT_THAT(plan_of(with(fast + R"(, "fluid": "quasisteady")")).error,
              HasSubstr("with dx = 0.4 and 162 nodes"));
}

TEST(ScenePlan, OfAnErrorAskedForSaysThatFinerRunsFollow) {
  const ScenePlan plan = plan_of(with(R"(, "fidelity": {"error": 0.01})"));
  EXPECT_THAT(plan.error, AllOf(HasSubstr("at most 0.01"), HasSubstr("finer runs follow")));
}

TEST(ScenePlan, ALatticeCostsMoreThanBoundaryIntegralsForARedCell) {
  const ScenePlan plan = plan_of(with(kRedCell + R"(, "fidelity": "fast")"));
  ASSERT_TRUE(plan.other_fluid);
  EXPECT_THAT(plan.other_fluid->words, StartsWith("quasisteady with dx = "));
  EXPECT_GT(plan.other_fluid->seconds, 3 * plan.seconds);
}

TEST(EqualAccuracy, TheOtherFluidIsAtMostAsFarOffAsTheCase) {
  for (const std::string keys : {R"(, "fluid": "quasisteady", "fidelity": "fast")",
                                 R"(, "fluid": "quasisteady", "fidelity": "standard")",
                                 R"(, "fluid": "stokes", "fidelity": {"nodes": 162})"}) {
    const Case c = with(keys), other = with_other_fluid(c).value();
    EXPECT_NE(other.has_grid(), c.has_grid());
    EXPECT_LE(measured_error(other).value().max, measured_error(c).value().max) << keys;
  }
}

TEST(EqualAccuracy, ACaseWithInertiaHasNoOtherFluid) {
  EXPECT_FALSE(with_other_fluid(with(R"(, "fluid": "unsteady", "Re": 0.5)")));
}

TEST(EqualAccuracy, ErrorsShrinkFromOneResolutionToTheNext) {
  for (const std::string fluid : {"stokes", "quasisteady", "unsteady"}) {
    const auto error = [&](const std::string& fidelity) {
      return measured_error(with(R"(, "Re": 0.05, "fluid": ")" + fluid + R"(", "fidelity": )" + fidelity))
          .value()
          .max;
    };
    EXPECT_LT(error(R"("standard")"), error(R"("fast")"));
  }
}

TEST(EqualAccuracy, AGridIsJudgedByItsSpacingAndItsMesh) {
  const auto error = [](const std::string& settings) {
    return measured_error(with(R"(, "fluid": "quasisteady", "fidelity": {)" + settings + "}"));
  };
  EXPECT_EQ(error(R"("dx": 0.1, "nodes": 642)")->max, error(R"("dx": 0.2, "nodes": 642)")->max);
  EXPECT_EQ(error(R"("dx": 0.2, "nodes": 2562)")->max, error(R"("dx": 0.2, "nodes": 642)")->max);
  EXPECT_FALSE(error(R"("dx": 0.2, "nodes": 42)"));
  EXPECT_THAT(error_in_words(with(R"(, "fidelity": {"nodes": 42})")), StartsWith("not measured"));
}

}  // namespace
}  // namespace capstan
