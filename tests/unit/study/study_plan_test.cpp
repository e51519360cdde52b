#include "runner/study/study_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/render/plan_text.hpp"
#include "tests/support/sample_studies.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

ordered_json plan_of_study(const nlohmann::json& axes) {
  return plan_json(parse_document(study_document("planned", axes).dump()));
}
ordered_json plan_of_case(const std::string& keys) {
  return plan_json(parse_document(R"({"Ca": 0.25)" + keys + "}"));
}

TEST(StudyPlan, OfACaseIsOneGroupOfOneCase) {
  const ordered_json plan = plan_of_case(R"(, "shape": "biconcave")");
  EXPECT_EQ(plan["kind"], "case");
  EXPECT_EQ(plan["case"]["Ca"], 0.25);
  EXPECT_EQ(plan["cases"], 1);
  ASSERT_EQ(plan["groups"].size(), 1u);
  EXPECT_EQ(plan["groups"][0]["choices"][0]["chosen"], "stokes");
  EXPECT_EQ(plan["groups"][0]["seconds"]["min"], plan["seconds"]["total"]);
}

TEST(StudyPlan, CasesThatDifferInNumbersAloneAreOneGroup) {
  const ordered_json plan = plan_of_study({{"Ca", {0.1, 0.2, 0.4}}, {"V", {2, 4, 8}}, {"E_b", {0.01, 0.02}}});
  EXPECT_EQ(plan["cases"], 18);
  ASSERT_EQ(plan["groups"].size(), 1u);
  const ordered_json& seconds = plan["groups"][0]["seconds"];
  EXPECT_LT(seconds["min"], seconds["max"]);
  EXPECT_NEAR(seconds["total"].get<double>() / 18,
              (seconds["min"].get<double>() + seconds["max"].get<double>()) / 2,
              seconds["max"].get<double>() / 2);
}

TEST(StudyPlan, CasesWithOtherModelsAreOtherGroupsTheLargestFirst) {
  const ordered_json plan = plan_of_study(
      {{"Ca", {0.1, 0.2}}, {"E_b", {0.01}}, {"V", {1, 2, 4}}, {"fluid", {"stokes", "quasisteady"}}});
  EXPECT_EQ(plan["number_of_groups"], 4);
  EXPECT_EQ(plan["grows"], false);
  std::vector<int> cases;
  for (const ordered_json& group : plan["groups"]) cases.push_back(group["cases"]);
  EXPECT_THAT(cases, ::testing::ElementsAre(4, 4, 2, 2));
  double total = 0;
  for (const ordered_json& group : plan["groups"]) total += group["seconds"]["total"].get<double>();
  EXPECT_NEAR(total, plan["seconds"]["total"].get<double>(), 0.01 * total);
}

TEST(StudyPlan, CountsTheCasesOfAWarning) {
  const ordered_json plan = plan_of_study({{"Ca", {0.005, 0.1, 0.2}}, {"E_b", {0.01}}});
  ASSERT_EQ(plan["groups"].size(), 1u);
  const ordered_json& warnings = plan["groups"][0]["warnings"];
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0]["cases"], 1);
  EXPECT_THAT(plan_text(plan), HasSubstr("at 1 of 3 cases Ca = 0.005 is outside"));
}

TEST(StudyPlan, OfAStudyWithManyScenesStaysShort) {
  nlohmann::json aspects;
  for (int i = 0; i < 50; ++i) aspects.push_back(0.2 + 0.01 * i);
  const nlohmann::json document = {
      {"name", "many"}, {"base", {{"shape", "oblate"}, {"Ca", 0.1}}}, {"axes", {{"aspect", aspects}}}};
  const ordered_json plan = plan_json(parse_document(document.dump()));
  EXPECT_EQ(plan["cases"], 50);
  EXPECT_EQ(plan["number_of_groups"], 50);
  EXPECT_EQ(plan["groups"].size(), 20u);
  EXPECT_THAT(plan_text(plan), HasSubstr("and 30 more groups"));
}

TEST(PlanText, SaysWhatIsModelledLeftOutAndWhatItCosts) {
  const std::string text = plan_text(plan_of_case(R"(, "shape": "biconcave", "V": 4, "fidelity": "fast")"));
  EXPECT_THAT(text, StartsWith("case "));
  EXPECT_THAT(
      text, AllOf(HasSubstr("\n  modelled\n    capsule: biconcave"), HasSubstr("fluid: auto became stokes: "),
                  HasSubstr("\n  left out, and what that changes\n"), HasSubstr("\n  expected error\n"),
                  HasSubstr(" of one core"), HasSubstr("the other flow model, quasisteady with dx"),
                  HasSubstr("\n  warnings\n    the membrane has no bending stiffness (E_b = 0)")));
}

TEST(PlanText, GivesRangesOnlyWhereThereAreSome) {
  EXPECT_THAT(
      plan_text(plan_of_case(R"(, "fluid": "quasisteady", "fidelity": {"preset": "fast", "kdt": 0.02})")),
      AllOf(HasSubstr("k dt = 0.02\n"), Not(HasSubstr("a case"))));
  const std::string study = plan_text(plan_of_study({{"Ca", {0.1, 0.2}}, {"fluid", {"unsteady"}}}));
  EXPECT_THAT(study,
              AllOf(StartsWith("study planned: 2 cases, "), HasSubstr(" a case"), HasSubstr("k dt = 0.0")));
}

TEST(PlanText, SaysWhereTheOtherFlowModelIsClearlyCheaper) {
  const std::string cell = R"(, "shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "V": 4)";
  EXPECT_THAT(plan_text(plan_of_case(cell + R"(, "fluid": "quasisteady", "fidelity": "standard")")),
              HasSubstr("; this is clearly cheaper\n"));
  EXPECT_THAT(plan_text(plan_of_case(cell + R"(, "fluid": "stokes", "fidelity": "fast")")),
              Not(HasSubstr("clearly cheaper")));
}

}  // namespace
}  // namespace capstan
