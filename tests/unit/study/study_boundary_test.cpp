// The parts "boundary" and "refine" of a study.
#include "runner/study/study_boundary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/study/study.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

json sought() {
  return json::parse(R"({"name": "b", "base": {"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015},
    "boundary": {"along": "Ca", "between": [0.05, 0.8], "for": {"V": [4, 2]}, "tolerance": 0.02, "explore": 5}})");
}

std::vector<std::string> pointers(const json& document) {
  std::vector<std::string> all;
  for (const Issue& issue : parse_study(document).issues) all.push_back(issue.pointer);
  return all;
}

TEST(StudyBoundary, FirstPointsOfEachRowAreEvenlySpacedInTheLogarithm) {
  const auto study = parse_study(sought()).value;
  ASSERT_TRUE(study);
  std::vector<double> at_four;
  for (std::size_t point = 0; point < study->points.size(); ++point)
    if (study->asked_at(point)["V"] == 4) at_four.push_back(study->asked_at(point)["Ca"]);
  EXPECT_THAT(at_four, ElementsAre(0.05, 0.1, 0.2, 0.4, 0.8));
  EXPECT_EQ(study->cases.size(), 10u);
  EXPECT_NEAR(study->boundary->explored_gap(), 1, 1e-12);
}

TEST(StudyBoundary, NeedsNoRowsToleranceAndNumberOfFirstValues) {
  json document = sought();
  for (const char* key : {"for", "tolerance", "explore"}) document["boundary"].erase(key);
  const auto study = parse_study(document).value;
  ASSERT_TRUE(study);
  EXPECT_EQ(study->cases.size(), std::size_t(StudyBoundary::kExplored));
  EXPECT_EQ(study->boundary->search.tolerance, StudyBoundary::kTolerance);
}

TEST(StudyBoundary, RunsEndOnceTheirLabelIsCertainUnlessTheBaseSaysOtherwise) {
  json document = sought();
  EXPECT_TRUE(parse_study(document).value->cases[0].until.classified);
  document["base"]["until"] = {{"kt", 20}};
  EXPECT_TRUE(parse_study(document).value->cases[0].until.classified);
  EXPECT_EQ(parse_study(document).value->cases[0].until.kt, 20);
  document["base"]["until"]["classified"] = false;
  EXPECT_FALSE(parse_study(document).value->cases[0].until.classified);
}

TEST(StudyBoundary, ReportsAllIssuesAtOnce) {
  json document = sought();
  document["axes"] = {{"Re", {0, 1}}};
  document["base"]["V"] = 3;
  document["boundary"] = {
      {"along", "shape"}, {"between", {1, 0.1}}, {"for", {{"V", json::array()}, {"width", {1}}}},
      {"tolerance", 0},   {"explore", 2.5},      {"how", 1}};
  EXPECT_THAT(pointers(document),
              UnorderedElementsAre("/axes", "/boundary/along", "/boundary/between", "/boundary/for/V",
                                   "/boundary/for/width", "/boundary/tolerance", "/boundary/explore",
                                   "/boundary/how"));
}

TEST(StudyBoundary, PointsToTheValueThatACaseRefuses) {
  json document = sought();
  document["boundary"]["for"]["V"] = {2, -1};
  EXPECT_THAT(pointers(document), ElementsAre("/boundary/for/V/1"));
  document = sought();
  document["boundary"]["between"] = {0.05, 1e9};
  EXPECT_THAT(pointers(document), ElementsAre("/boundary/between"));
}

TEST(StudyBoundary, ParametersThatItVariesCannotStandInTheBase) {
  json document = sought();
  document["base"]["V"] = 3;
  document["base"]["Ca"] = 0.1;
  EXPECT_THAT(pointers(document), UnorderedElementsAre("/base/V", "/base/Ca"));
}

TEST(StudyBoundary, SearchedParameterCannotBeFixedInTheRows) {
  json document = sought();
  document["boundary"]["for"] = {{"Ca", {0.1}}};
  EXPECT_THAT(pointers(document), ElementsAre("/boundary/for/Ca"));
}

TEST(StudyBoundary, MistypedKeyIsOneIssue) {
  json document = sought();
  document["boundary"]["betwen"] = document["boundary"]["between"];
  document["boundary"].erase("between");
  EXPECT_THAT(pointers(document), ElementsAre("/boundary/betwen"));
}

json refined(const json& refine) {
  return {{"name", "r"},
          {"base", json::object()},
          {"axes", {{"Ca", {0.1, 0.5}}, {"V", {1, 5}}, {"shape", {"sphere", "biconcave"}}}},
          {"refine", refine}};
}

TEST(StudyRefinement, NamesTwoAxesWithNumbers) {
  EXPECT_THAT(pointers(refined({{"Ca", 0.02}, {"V", 0.25}})), ::testing::IsEmpty());
  EXPECT_THAT(pointers(refined({{"Ca", 0.02}})), ElementsAre("/refine"));
  EXPECT_THAT(pointers(refined({{"Ca", 0.02}, {"shape", 1}})), ElementsAre("/refine/shape"));
  EXPECT_THAT(pointers(refined({{"Ca", 0}, {"Re", 1}})), UnorderedElementsAre("/refine/Ca", "/refine/Re"));
}

TEST(StudyRefinement, OfAStoredStudyIsThatOfItsDocument) {
  const auto refinement = refinement_of(refined({{"V", 0.25}, {"Ca", 0.02}}));
  ASSERT_TRUE(refinement);
  EXPECT_EQ(refinement->axes, (std::array<std::string, 2>{"Ca", "V"}));
  EXPECT_EQ(refinement->sides, (std::array<double, 2>{0.02, 0.25}));
}

}  // namespace
}  // namespace capstan
