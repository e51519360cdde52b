#include "runner/study/study_base.hpp"

#include <gtest/gtest.h>

#include "runner/study/study.hpp"

namespace capstan {
namespace {

using nlohmann::json;

bool is_classified(const json& base, const json& axes) {
  const ParsedStudy parsed = parse_study({{"name", "diagram"}, {"base", base}, {"axes", axes}});
  return parsed.value.value().cases[0].until.classified;
}

const json kTwoNumbers = {{"Ca", {0.1, 0.2}}, {"V", {1, 2}}};

TEST(StudyBase, RunsOfAPhaseDiagramEndOnceTheirLabelIsCertain) {
  EXPECT_TRUE(is_classified(json::object(), kTwoNumbers));
  EXPECT_TRUE(is_classified({{"until", {{"kt", 20}}}}, kTwoNumbers));
}

TEST(StudyBase, RunsOfAPhaseDiagramGoToTheEndIfTheBaseSaysSo) {
  EXPECT_FALSE(is_classified({{"until", {{"classified", false}}}}, kTwoNumbers));
}

TEST(StudyBase, CurvesOverOneNumberAreComputedToTheEnd) {
  EXPECT_FALSE(is_classified(json::object(), {{"Ca", {0.1, 0.2}}, {"V", json::array({2})}}));
  EXPECT_FALSE(is_classified(json::object(), {{"Ca", {0.1, 0.2}}}));
  EXPECT_FALSE(is_classified(json::object(), {{"Ca", {0.1, 0.2}}, {"fluid", {"stokes", "quasisteady"}}}));
}

TEST(StudyBase, NotesSayHowToComputeAllRunsToTheEnd) {
  const json document = {{"name", "diagram"}, {"base", json::object()}, {"axes", kTwoNumbers}};
  const std::vector<std::string> notes = parse_study(document).value.value().notes;
  EXPECT_NE(json(notes).dump().find("end as soon as their label is certain"), std::string::npos);
}

}  // namespace
}  // namespace capstan
