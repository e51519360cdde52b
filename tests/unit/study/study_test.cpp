#include "runner/study/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

json red_cell_grid() {
  return json::parse(R"({"name": "grid",
    "base": {"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "fidelity": "fast"},
    "axes": {"V": [2, 4], "Ca": [0.25, 0.75]}})");
}

std::vector<std::string> pointers(const ParsedStudy& parsed) {
  std::vector<std::string> all;
  for (const Issue& issue : parsed.issues) all.push_back(issue.pointer);
  return all;
}

std::vector<std::string> faults_of(const json& document) { return pointers(parse_study(document)); }

std::vector<double> capillary_numbers(const Study& study) {
  std::vector<double> all;
  for (const Case& c : study.cases) all.push_back(c.Ca);
  return all;
}

TEST(Study, ExpandsToTheProductOfItsAxesWithTheLastAxisFastest) {
  const auto study = parse_study(red_cell_grid()).value;
  ASSERT_TRUE(study);
  ASSERT_EQ(study->cases.size(), 4u);
  EXPECT_EQ(study->axes[0].parameter(), "Ca");
  EXPECT_THAT(capillary_numbers(*study), ElementsAre(0.25, 0.25, 0.75, 0.75));
  EXPECT_EQ(study->cases[1].V, 4);
  EXPECT_EQ(study->cases[1].C, 5);
}

TEST(Study, WithoutAxesIsOneCase) {
  const auto study = parse_study(json::parse(R"({"name": "one", "base": {"Ca": 0.1}})")).value;
  ASSERT_TRUE(study);
  EXPECT_EQ(study->cases.size(), 1u);
}

TEST(Study, EqualCasesStandOnce) {
  json document = red_cell_grid();
  document["axes"]["Ca"] = {0.25, 0.25, 0.25};
  EXPECT_EQ(parse_study(document).value->cases.size(), 2u);
}

TEST(Study, LinearRangeIncludesBothEnds) {
  json document = red_cell_grid();
  document["axes"] = {{"Ca", {{"from", 0.1}, {"to", 0.7}, {"count", 4}}}};
  EXPECT_THAT(capillary_numbers(*parse_study(document).value), ElementsAre(0.1, 0.3, 0.5, 0.7));
}

TEST(Study, LogarithmicRangeHasEqualRatiosAndTypableValues) {
  json document = red_cell_grid();
  document["axes"] = {{"Ca", {{"from", 0.05}, {"to", 1}, {"count", 4}, {"scale", "log"}}}};
  EXPECT_THAT(capillary_numbers(*parse_study(document).value), ElementsAre(0.05, 0.135721, 0.368403, 1));
}

TEST(Study, FidelityMayBeAnAxisOfPresetsAndKnobs) {
  json document = red_cell_grid();
  document["base"].erase("fidelity");
  document["axes"]["fidelity"] = {"fast", {{"dx", 0.2}, {"nodes", 2562}}};
  EXPECT_EQ(parse_study(document).value->cases.size(), 8u);
  document["axes"]["fidelity"] = {"fast", {{"dx", "small"}}};
  EXPECT_THAT(faults_of(document), ElementsAre("/axes/fidelity/1/dx"));
}

TEST(Study, FaultOfABaseKeyIsReportedOnceWhateverTheNumberOfCases) {
  json document = red_cell_grid();
  document["base"]["law"] = "neo-hookean";
  EXPECT_THAT(faults_of(document), ElementsAre("/base/C"));
}

TEST(Study, AKeyOfTheBaseThatIsAnAxisIsAFaultEvenIfTheAxisIsFaultyItself) {
  json document = red_cell_grid();
  document["base"]["V"] = 4;
  document["axes"]["V"] = {{"from", 0}, {"to", 1}, {"count", 3}, {"scale", "log"}};
  EXPECT_THAT(faults_of(document), UnorderedElementsAre("/axes/V/from", "/base/V"));
}

TEST(Study, FaultOfAnAxisValueStandsAtThatValue) {
  json document = red_cell_grid();
  document["axes"]["Ca"] = {0.25, -1, nullptr, "a lot"};
  EXPECT_THAT(faults_of(document), ElementsAre("/axes/Ca/1", "/axes/Ca/2", "/axes/Ca/3"));
}

TEST(Study, FaultsInsideARangeStandAtTheRange) {
  json document = red_cell_grid();
  document["axes"]["Ca"] = {{"from", -5}, {"to", 1}, {"count", 50}};
  EXPECT_THAT(faults_of(document), ElementsAre("/axes/Ca"));
}

TEST(Study, AllFaultsAreReportedTogether) {
  const json document = json::parse(R"({"name": "no spaces", "typo": 1,
    "base": {"Ca": 0.1, "V": "two", "until": {"kt": -1}, "colour": "red"},
    "axes": {"Ca": [0.1], "Re": [], "dx": [0.1], "E_b": {"from": 0, "to": "a", "scale": "log", "step": 1}}})");
  EXPECT_THAT(faults_of(document),
              UnorderedElementsAre("/name", "/typo", "/base/V", "/base/until/kt", "/base/colour", "/base/Ca",
                                   "/axes/Re", "/axes/dx", "/axes/E_b/from", "/axes/E_b/to",
                                   "/axes/E_b/count", "/axes/E_b/step"));
}

TEST(Study, GridOfAMillionCasesIsOneMessageBeforeItIsExpanded) {
  json document = red_cell_grid();
  document["axes"]["Ca"] = {{"from", 0.1}, {"to", 1}, {"count", 500000}};
  const ParsedStudy parsed = parse_study(document);
  EXPECT_THAT(pointers(parsed), ElementsAre("/axes"));
  EXPECT_THAT(parsed.issues[0].message, HasSubstr("1000000 cases"));
}

TEST(Study, TruncatedTextIsOneFault) {
  const std::string text = red_cell_grid().dump();
  for (std::size_t length = 0; length < text.size(); ++length) {
    const ParsedStudy parsed = parse_study_text(text.substr(0, length));
    EXPECT_FALSE(parsed.value) << length;
    EXPECT_EQ(parsed.issues.size(), 1u) << length;
  }
}

TEST(Study, TextThatIsNoObjectIsRefused) {
  for (const char* text : {"[]", "3", "null", "\"study\"", "{\"base\": [], \"name\": \"a\"}"})
    EXPECT_FALSE(parse_study_text(text).issues.empty()) << text;
}

TEST(Study, NotANumberIsRefused) {
  EXPECT_THAT(parse_study_text(R"({"name": "a", "base": {"Ca": NaN}})").issues,
              Contains(Field(&Issue::message, HasSubstr("not valid JSON"))));
  EXPECT_FALSE(parse_study_text(R"({"name": "a", "base": {"Ca": 1e999}})").value);
}

/// Each of these took minutes when the document was looked at again for every case.
TEST(Study, UnknownKeysOfTheBaseAreLookedAtOnceForAllCases) {
  json document = red_cell_grid();
  document["axes"] = {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", 10000}}}};
  for (int i = 0; i < 6000; ++i) {
    document["base"]["key" + std::to_string(i)] = i;
    document["base"]["until"]["key" + std::to_string(i)] = i;
  }
  const ParsedStudy parsed = parse_study(document);
  EXPECT_EQ(parsed.issues.size(), 101u);
  EXPECT_EQ(parsed.issues.back().message, "and 11900 more faults");
}

TEST(Study, FaultyValueOfAnAxisIsLookedAtOnceForAllCases) {
  json document = red_cell_grid();
  document["base"].erase("fidelity");
  json knobs;
  for (int i = 0; i < 6000; ++i) knobs["key" + std::to_string(i)] = i;
  document["axes"] = {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", 5000}}}, {"fidelity", {"fast", knobs}}};
  EXPECT_EQ(parse_study(document).issues.size(), 101u);
}

TEST(Study, LongWordInTheBaseIsLookedAtOnceForAllCases) {
  json document = red_cell_grid();
  document["base"]["shape"] = std::string(500'000, 'a');
  document["axes"] = {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", 10000}}}};
  EXPECT_THAT(faults_of(document), ElementsAre("/base/shape"));
}

TEST(Study, ListOfManyObjectsIsReadInOnePass) {
  std::string text = "[{}";
  for (int i = 0; i < 300'000; ++i) text += ",{}";
  EXPECT_EQ(parse_study_text(text + "]").issues.size(), 1u);
  std::string object = "{\"name\": \"a\", \"base\": {\"Ca\": [{}";
  for (int i = 0; i < 300'000; ++i) object += ",{}";
  EXPECT_EQ(parse_study_text(object + "]}}").issues.size(), 1u);
}

TEST(Study, FaultsOfOneKeyDoNotHideThoseOfAnother) {
  json document = red_cell_grid();
  document["base"]["fidelity"] = {{"nodes", 100}, {"dx", 7}, {"colour", "red"}};
  document["base"]["until"] = {{"kt", 0}, {"colour", "red"}};
  document["axes"]["Ca"] = {-1, 0.25, -1};
  EXPECT_THAT(faults_of(document),
              UnorderedElementsAre("/base/fidelity/nodes", "/base/fidelity/dx", "/base/fidelity/colour",
                                   "/base/until/kt", "/base/until/colour", "/axes/Ca/0", "/axes/Ca/2"));
}

}  // namespace
}  // namespace capstan
