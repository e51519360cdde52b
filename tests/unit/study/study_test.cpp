#include "runner/study/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

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

std::vector<std::string> pointers_of_issues(const json& document) { return pointers(parse_study(document)); }

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
  EXPECT_EQ(study->cases[1].law_constants.at(0), 5);
}

TEST(Study, MistypedKeyIsOneIssueThatNamesTheNearest) {
  const auto only = [](json document) {
    const Issues issues = parse_study(document).issues;
    return issues.size() == 1 ? issues[0].pointer + ": " + issues[0].message
                              : std::to_string(issues.size()) + " issues";
  };
  json document = red_cell_grid();
  document["axes"] = {{"ca", {0.25, 0.5}}, {"V", {2, 4}}};
  EXPECT_EQ(only(document), "/axes/ca: unknown key; did you mean \"Ca\"?");
  document["axes"] = {{"V", {2, 4}}};
  document["base"]["ca"] = 0.25;
  EXPECT_EQ(only(document), "/base/ca: unknown key; did you mean \"Ca\"?");
  document = red_cell_grid();
  document["axis"] = document["axes"];
  document.erase("axes");
  EXPECT_EQ(only(document), "/axis: unknown key; did you mean \"axes\"?");
  document = red_cell_grid();
  document["base"]["law"] = "Skalak";
  EXPECT_THAT(only(document),
              HasSubstr("/base/law: must be one of: neo-hookean, skalak; is \"Skalak\"; did you mean"));
  document = red_cell_grid();
  document["base"].erase("law");
  document["axes"]["law"] = {"neo-hookean", "Skalak"};
  EXPECT_THAT(only(document),
              HasSubstr("/axes/law/1: must be one of: neo-hookean, skalak; is \"Skalak\"; did you mean"));
}

TEST(Study, WithoutAxesIsOneCase) {
  const auto study = parse_study(json::parse(R"({"name": "one", "base": {"Ca": 0.1}})")).value;
  ASSERT_TRUE(study);
  EXPECT_EQ(study->cases.size(), 1u);
}

TEST(Study, ValueThatStandsTwiceOnAnAxisCountsOnceAndThatIsSaid) {
  json document = red_cell_grid();
  document["axes"]["Ca"] = json::parse("[0.25, 0.5, 0.25, 0.250]");
  document["axes"]["V"] = json::parse("[4, 4.0]");
  const auto study = parse_study(document).value;
  ASSERT_TRUE(study);
  EXPECT_THAT(capillary_numbers(*study), ElementsAre(0.25, 0.5));
  EXPECT_THAT(study->notes, AllOf(Contains("axis Ca: 0.25 stands more than once and counts once"),
                                  Contains("axis V: 4 stands more than once and counts once")));
}

TEST(Study, PointsThatResolveToOneCaseAreAllKeptAndThatIsSaid) {
  const auto study = parse_study(json::parse(R"({"name": "merged", "base": {"fluid": "stokes"},
    "axes": {"Ca": [0.1, 0.2], "Re": [0, 0.05, 0.1]}})"))
                         .value;
  ASSERT_TRUE(study);
  EXPECT_EQ(study->cases.size(), 2u);
  EXPECT_THAT(study->points, ElementsAre(0u, 0u, 0u, 1u, 1u, 1u));
  EXPECT_EQ(study->asked_at(4), json::parse(R"({"Ca": 0.2, "Re": 0.05, "fluid": "stokes"})"));
  EXPECT_THAT(study->notes,
              Contains("6 points are 2 cases, each computed once: point 2 is the same case as point 1, "
                       "point 3 is the same case as point 1, point 5 is the same case as point 4, "
                       "point 6 is the same case as point 4"));
}

json conditional(const char* base, const char* axes) {
  return {{"name", "conditional"}, {"base", json::parse(base)}, {"axes", json::parse(axes)}};
}

TEST(Study, KeyWithoutEffectAtSomePointsIsDroppedThereAndThatIsSaid) {
  const auto laws =
      parse_study(conditional(R"({"Ca": 0.1, "C": 5})", R"({"law": ["neo-hookean", "skalak"]})")).value;
  ASSERT_TRUE(laws);
  EXPECT_EQ(laws->cases.size(), 2u);
  EXPECT_EQ(laws->cases[1].law_constants.at(0), 5);
  EXPECT_THAT(laws->notes,
              Contains("C is dropped at 1 of 2 points, where it has no effect: only the skalak law has "
                       "the constant C"));
  for (const auto& [base, axes, cases] :
       {std::tuple{R"({"Ca": 0.1})", R"({"law": ["neo-hookean", "skalak"], "C": [0, 1, 10]})", 4u},
        {R"({"Ca": 0.1})", R"({"law": ["neo-hookean", "skalak"], "C": {"from": 0, "to": 10, "count": 3}})",
         4u},
        {R"({"Ca": 0.1, "aspect": 0.6})", R"({"shape": ["sphere", "oblate", "biconcave"]})", 3u},
        {R"({"Ca": 0.1, "c0": 2, "bending": "variational"})",
         R"({"E_b": {"from": 0, "to": 0.02, "count": 5}})", 5u},
        {R"({"Ca": 0.1})", R"({"E_b": [0, 0.01], "c0": ["initial", "uniform", 1]})", 4u},
        {R"({"Ca": 0.1, "fidelity": {"preset": "fast", "dx": 0.1}})",
         R"({"fluid": ["stokes", "quasisteady"]})", 2u},
        {R"({"Ca": 0.1, "fidelity": {"box": 6.4}})", R"({"fluid": ["stokes", "quasisteady", "transient"]})",
         3u},
        {R"({"Ca": 0.1, "fidelity": {"kdt": 0.01}})", R"({"fluid": ["quasisteady", "transient"]})", 2u},
        {R"({"Ca": 0.1, "fluid": "stokes", "fidelity": {"tolerance": 1e-5}})", R"({"V": [1, 4]})", 2u}}) {
    const ParsedStudy parsed = parse_study(conditional(base, axes));
    ASSERT_TRUE(parsed.value) << axes << " " << parsed.issues.at(0).pointer << " "
                              << parsed.issues.at(0).message;
    EXPECT_EQ(parsed.value->cases.size(), cases) << axes;
    EXPECT_THAT(parsed.value->notes, Contains(HasSubstr("is dropped at"))) << axes;
  }
}

TEST(Study, KeyWithoutEffectAtEveryPointIsAnIssue) {
  EXPECT_THAT(pointers_of_issues(conditional(R"({"Ca": 0.1, "C": 5})", R"({"law": ["neo-hookean"]})")),
              ElementsAre("/base/C"));
  EXPECT_THAT(pointers_of_issues(conditional(R"({"Ca": 0.1, "c0": 5})", R"({"V": [1, 2]})")),
              ElementsAre("/base/c0"));
  EXPECT_THAT(pointers_of_issues(conditional(R"({"Ca": 0.1})", R"({"C": [5, 6]})")),
              ElementsAre("/axes/C/0", "/axes/C/1"));
  EXPECT_THAT(pointers_of_issues(
                  conditional(R"({"Ca": 0.1})", R"({"aspect": {"from": 0.3, "to": 0.6, "count": 3}})")),
              ElementsAre("/axes/aspect"));
  EXPECT_THAT(
      pointers_of_issues(conditional(
          R"({"Ca": 0.1})", R"({"fluid": ["stokes"], "fidelity": ["fast", {"preset": "fast", "dx": 0.1}]})")),
      ElementsAre("/axes/fidelity/1/dx"));
}

TEST(Study, KeyThatAPointNeedsMustBeThere) {
  EXPECT_THAT(pointers_of_issues(conditional(R"({"Ca": 0.1})", R"({"law": ["neo-hookean", "skalak"]})")),
              ElementsAre("/base/C"));
  EXPECT_THAT(pointers_of_issues(conditional(R"({"Ca": 0.1})", R"({"shape": ["sphere", "oblate"]})")),
              ElementsAre("/base/aspect"));
}

TEST(Study, AnInvalidAxisMakesNoOtherKeyUseless) {
  EXPECT_THAT(pointers_of_issues(conditional(R"({"Ca": 0.1, "C": 5})", R"({"law": "skalak"})")),
              ElementsAre("/axes/law"));
}

TEST(Study, AnInvalidValueOfAnAxisMakesNoOtherKeyUseless) {
  const json document =
      conditional(R"({"Ca": 0.1})", R"({"law": ["neo-hookean", "Skalak"], "C": [1, 2, 3]})");
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/axes/law/1"));
  const json also_useless = conditional("{}", R"({"Ca": [-1, 0.1], "V": [1, 2], "C": [1, 2]})");
  EXPECT_THAT(pointers_of_issues(also_useless), UnorderedElementsAre("/axes/Ca/0", "/axes/C/0", "/axes/C/1"));
}

TEST(Study, MistypedKeyOfARangeIsOneIssueThatNamesTheNearest) {
  const Issues issues =
      parse_study(conditional("{}", R"({"Ca": {"form": 0.1, "to": 1, "count": 3, "scale": "Log"}})")).issues;
  ASSERT_EQ(issues.size(), 2u);
  EXPECT_EQ(issues[0].pointer + ": " + issues[0].message,
            "/axes/Ca/form: unknown key; did you mean \"from\"?");
  EXPECT_THAT(issues[1].message, HasSubstr("did you mean \"log\"?"));
}

TEST(Study, WhatTheSolverChoosesIsSaid) {
  const auto study =
      parse_study(conditional("{}", R"({"Ca": [0.1, 0.2], "fluid": ["auto", "stokes"]})")).value;
  ASSERT_TRUE(study);
  EXPECT_THAT(study->notes, Contains(HasSubstr("at 2 of 4 points fluid: auto became stokes: ")));
}

TEST(Study, DoubtfulSettingsAreSaidBeforeTheRun) {
  const auto study = parse_study(conditional(R"({"Ca": 0.1, "fidelity": {"dx": 0.4, "nodes": 162}})",
                                             R"({"V": [1, 30], "fluid": ["unsteady", "quasisteady"]})"))
                         .value;
  ASSERT_TRUE(study);
  EXPECT_THAT(study->notes, Contains(HasSubstr("at 2 of 4 points warning: V = 30 on a lattice of dx = 0.4")));
}

TEST(Study, ValueThatIsValidForAnotherShapeAloneSaysForWhich) {
  const ParsedStudy parsed =
      parse_study(conditional(R"({"Ca": 0.1})", R"({"shape": ["oblate", "prolate"], "aspect": [0.5, 2]})"));
  EXPECT_THAT(
      parsed.issues,
      UnorderedElementsAre(Field(&Issue::message, "is 2, must be >= 0.1 and <= 1 for an oblate shape"),
                           Field(&Issue::message, "is 0.5, must be >= 1 and <= 5 for a prolate shape")));
}

TEST(Study, OneStudyInTwoSpellingsIsOneDocument) {
  const auto document = [](const char* text) { return parse_study_text(text).value.value().document.dump(); };
  EXPECT_EQ(
      document(R"({"name": "a", "base": {"Ca": 0.5, "V": 4, "E_b": 1}, "axes": {"c0": [0, 1]}})"),
      document(R"({"name": "a", "base": {"Ca": 5e-1, "V": 4.0, "E_b": 1.0}, "axes": {"c0": [-0.0, 1.0]}})"));
}

TEST(Study, InvalidValuesThatAreEqualAreOneIssue) {
  json document = red_cell_grid();
  document["axes"]["Ca"] = {0.25, -1, -1};
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/axes/Ca/1"));
}

TEST(Study, LinearRangeIncludesBothEnds) {
  json document = red_cell_grid();
  document["axes"] = {{"Ca", {{"from", 0.1}, {"to", 0.7}, {"count", 4}}}};
  EXPECT_THAT(capillary_numbers(*parse_study(document).value), ElementsAre(0.1, 0.3, 0.5, 0.7));
}

json range(double from, double to, int count) { return {{"from", from}, {"to", to}, {"count", count}}; }

std::vector<json> values_of(const std::string& parameter, const json& range) {
  Issues issues;
  const auto axis = read_axis(parameter, range, "/axes/" + parameter, issues);
  std::vector<json> values;
  for (std::size_t i = 0; axis && static_cast<double>(i) < axis->size(); ++i)
    values.push_back(axis->value(i));
  return values;
}

TEST(Study, RangeThroughZeroContainsZero) {
  EXPECT_THAT(values_of("c0", range(-0.3, 0.6, 10)),
              ElementsAre(-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6));
  for (const auto& [from, to, count] :
       {std::tuple{-1., 1., 201}, {-0.7, 0.7, 15}, {-3e-7, 6e-7, 10}, {-100., 200., 31}}) {
    const std::vector<json> values = values_of("c0", range(from, to, count));
    EXPECT_THAT(values, Contains(0.0)) << from;
    for (const json& value : values)
      EXPECT_TRUE(value == 0.0 || std::abs(value.get<double>()) > 1e-3 * (to - from) / count) << value;
  }
}

TEST(Study, RangeHasAsManyDigitsAsTellItsValuesApart) {
  EXPECT_THAT(values_of("V", range(1, 1.00001, 11)),
              ElementsAre(1, 1.000001, 1.000002, 1.000003, 1.000004, 1.000005, 1.000006, 1.000007, 1.000008,
                          1.000009, 1.00001));
  for (const double width : {1e-5, 1e-8, 1e-11}) {
    const std::vector<json> values = values_of("V", range(1, 1 + width, 12));
    ASSERT_EQ(values.size(), 12u) << width;
    for (std::size_t i = 1; i < 12; ++i)
      EXPECT_NEAR(values[i].get<double>() - values[i - 1].get<double>(), width / 11, 0.1 * width / 11)
          << width;
  }
}

TEST(Study, RangeWhoseValuesCannotBeToldApartIsRefused) {
  json document = red_cell_grid();
  document["axes"]["V"] = range(1, 1 + 1e-13, 11);
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/axes/V"));
  document["axes"]["V"] = range(2, 2, 5);
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/axes/V"));
  document["axes"]["V"] = range(0, 0, 2);
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/axes/V"));
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
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/axes/fidelity/1/dx"));
}

TEST(Study, IssueOfABaseKeyIsReportedOnceWhateverTheNumberOfCases) {
  json document = red_cell_grid();
  document["base"]["law"] = "neo-hookean";
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/base/C"));
}

TEST(Study, AKeyOfTheBaseThatIsAnAxisIsAnIssueEvenIfTheAxisIsInvalidItself) {
  json document = red_cell_grid();
  document["base"]["V"] = 4;
  document["axes"]["V"] = {{"from", 0}, {"to", 1}, {"count", 3}, {"scale", "log"}};
  EXPECT_THAT(pointers_of_issues(document), UnorderedElementsAre("/axes/V/from", "/base/V"));
}

TEST(Study, IssueOfAnAxisValueStandsAtThatValue) {
  json document = red_cell_grid();
  document["axes"]["Ca"] = {0.25, -1, nullptr, "a lot"};
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/axes/Ca/1", "/axes/Ca/2", "/axes/Ca/3"));
}

TEST(Study, IssuesInsideARangeStandAtTheRange) {
  json document = red_cell_grid();
  document["axes"]["Ca"] = {{"from", -5}, {"to", 1}, {"count", 50}};
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/axes/Ca"));
}

TEST(Study, AllIssuesAreReportedTogether) {
  const json document = json::parse(R"({"name": "no spaces", "typo": 1,
    "base": {"Ca": 0.1, "V": "two", "until": {"kt": -1}, "colour": "red"},
    "axes": {"Ca": [0.1], "Re": [], "dx": [0.1], "E_b": {"from": 0, "to": "a", "scale": "log", "step": 1}}})");
  EXPECT_THAT(pointers_of_issues(document),
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

TEST(Study, TruncatedTextIsOneIssue) {
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
  EXPECT_EQ(parsed.issues.back().message, "and 11900 more issues");
}

TEST(Study, AnInvalidValueOfAnAxisIsCheckedOnceForAllCases) {
  json document = red_cell_grid();
  document["base"].erase("fidelity");
  json knobs;
  for (int i = 0; i < 6000; ++i) knobs["key" + std::to_string(i)] = i;
  document["axes"] = {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", 5000}}}, {"fidelity", {"fast", knobs}}};
  EXPECT_EQ(parse_study(document).issues.size(), 101u);
}

TEST(Study, LongWordInTheBaseIsCheckedOnceForAllCases) {
  json document = red_cell_grid();
  document["base"]["shape"] = std::string(500'000, 'a');
  document["axes"] = {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", 10000}}}};
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/base/shape"));
}

TEST(Study, ListOfManyObjectsIsReadInOnePass) {
  std::string text = "[{}";
  for (int i = 0; i < 300'000; ++i) text += ",{}";
  EXPECT_EQ(parse_study_text(text + "]").issues.size(), 1u);
  std::string object = "{\"name\": \"a\", \"base\": {\"Ca\": [{}";
  for (int i = 0; i < 300'000; ++i) object += ",{}";
  EXPECT_EQ(parse_study_text(object + "]}}").issues.size(), 1u);
}

TEST(Study, IssuesOfOneKeyDoNotHideThoseOfAnother) {
  json document = red_cell_grid();
  document["base"]["fidelity"] = {{"nodes", 100}, {"dx", 7}, {"colour", "red"}};
  document["base"]["until"] = {{"kt", 0}, {"colour", "red"}};
  document["axes"]["Ca"] = {-1, 0.25, -2};
  EXPECT_THAT(pointers_of_issues(document),
              UnorderedElementsAre("/base/fidelity/nodes", "/base/fidelity/dx", "/base/fidelity/colour",
                                   "/base/until/kt", "/base/until/colour", "/axes/Ca/0", "/axes/Ca/2"));
}

}  // namespace
}  // namespace capstan
