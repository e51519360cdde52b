#include "solver/case/case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "solver/case/content_id.hpp"
#include "solver/case/equal_steps.hpp"
#include "solver/case/parse.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// The biconcave capsule of the paper's Fig. 16.
const json kRedBloodCell = json::parse(R"({
  "shape": "biconcave", "law": "skalak", "C": 5, "Ca": 0.4, "V": 4, "Re": 0.05, "E_b": 0.015, "fluid": "quasisteady"})");

json with(json object, const char* pointer, const json& value) {
  object[json::json_pointer(pointer)] = value;
  return object;
}

Case valid(const json& object) {
  const ParsedCase parsed = parse_case(object);
  EXPECT_TRUE(parsed.value) << object << "\n" << ::testing::PrintToString(parsed.issues.size());
  return parsed.value.value_or(Case{});
}

std::vector<std::string> pointers_of_issues(const json& object) {
  std::vector<std::string> pointers;
  for (const Issue& issue : parse_case(object).issues) pointers.push_back(issue.pointer);
  return pointers;
}

std::string only_message(const json& object) {
  const Issues issues = parse_case(object).issues;
  return issues.size() == 1 ? issues.front().message : std::to_string(issues.size()) + " issues";
}

TEST(ParseCase, ReadsWhatTheFileSays) {
  const Case c = valid(kRedBloodCell);
  EXPECT_EQ(c.shape, Shape::biconcave);
  EXPECT_EQ(c.law, find_strain_law("skalak"));
  EXPECT_THAT(c.law_constants, ElementsAre(5));
  EXPECT_EQ(c.Ca, 0.4);
  EXPECT_EQ(c.V, 4);
  EXPECT_EQ(c.E_b, 0.015);
  EXPECT_EQ(c.bending, BendingModel::variational);
  EXPECT_TRUE(std::holds_alternative<InitialCurvature>(c.c0));
}

TEST(ParseCase, TheCapillaryNumberAloneMakesASphere) {
  const Case c = valid({{"Ca", 0.05}});
  EXPECT_EQ(c.shape, Shape::sphere);
  EXPECT_EQ(c.law, find_strain_law("neo-hookean"));
  EXPECT_EQ(c.fidelity.nodes, 2562);
}

TEST(ParseCase, ReportsAllIssuesAtOnceEachAtItsPointer) {
  const json object = json::parse(R"({
    "shape": "cube", "law": "skalak", "Ca": -1, "V": "four", "colour": "red",
    "until": {"kt": 0, "patience": 1}, "fidelity": {"nodes": 1000, "dx": 0.1}, "outputs": []})");
  EXPECT_THAT(pointers_of_issues(object),
              UnorderedElementsAre("/shape", "/C", "/Ca", "/V", "/colour", "/until/kt", "/until/patience",
                                   "/fidelity/nodes", "/outputs"));
}

TEST(ParseCase, ACaseWithIssuesHasNoValue) { EXPECT_FALSE(parse_case({{"Ca", -1}}).value); }

TEST(ParseCase, OnlyAnObjectIsACase) {
  for (const json& other : {json(), json(3), json("sphere"), json::array({1, 2})})
    EXPECT_THAT(pointers_of_issues(other), ElementsAre("")) << other;
}

TEST(ParseCase, RefusesKeysItDoesNotKnow) {
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"ca", 0.1}}), HasSubstr("unknown key"));
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"a/b~c", 1}}), ElementsAre("/a~1b~0c"));
}

TEST(ParseCase, MistypedWordIsOneIssueThatNamesTheNearest) {
  const auto message = [](json keys) {
    keys["Ca"] = 0.1;
    return only_message(keys);
  };
  EXPECT_THAT(message({{"law", "Skalak"}, {"C", 5}}), HasSubstr("did you mean \"skalak\"?"));
  EXPECT_THAT(message({{"law", "neohookean"}}), HasSubstr("did you mean \"neo-hookean\"?"));
  EXPECT_THAT(message({{"shape", "Oblate"}, {"aspect", 0.5}}), HasSubstr("did you mean \"oblate\"?"));
  EXPECT_THAT(message({{"fluid", "Stokes"}}), HasSubstr("did you mean \"stokes\"?"));
  EXPECT_THAT(message({{"fluid", "Auto"}}), HasSubstr("did you mean \"auto\"?"));
  EXPECT_THAT(message({{"fidelity", "Fast"}}), HasSubstr("did you mean \"fast\"?"));
  EXPECT_THAT(message({{"fidelity", {{"preset", "standart"}}}}), HasSubstr("did you mean \"standard\"?"));
  EXPECT_THAT(message({{"E_b", 0.01}, {"c0", "Initial"}}), HasSubstr("did you mean \"initial\"?"));
}

TEST(ParseCase, UnknownWordIsNoReasonToDoubtWhatDependsOnIt) {
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"law", "mooney-rivlin"}, {"C", 5}}), ElementsAre("/law"));
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"shape", "cube"}, {"aspect", 0.5}}), ElementsAre("/shape"));
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"E_b", "soft"}, {"c0", 0}}), ElementsAre("/E_b"));
}

TEST(ParseCase, MistypedKeyIsOneIssueThatNamesTheNearest) {
  EXPECT_THAT(only_message({{"ca", 0.1}}), HasSubstr("unknown key; did you mean \"Ca\"?"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"Eb", 0.01}, {"c0", 0}}), HasSubstr("did you mean \"E_b\"?"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"fidelty", {{"nodes", 642}}}}), HasSubstr("\"fidelity\"?"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"fidelity", {{"node", 642}}}}), HasSubstr("\"nodes\"?"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"until", {{"KT", 3}}}}), HasSubstr("did you mean \"kt\"?"));
  EXPECT_THAT(pointers_of_issues({{"ca", 0.1}}), ElementsAre("/ca"));
  EXPECT_EQ(only_message({{"Ca", 0.1}, {"colour", "red"}}), "unknown key");
}

TEST(ParseCase, RefusesKeysWithoutEffectAndSaysWhy) {
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"C", 5}}), HasSubstr("no effect"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"aspect", 0.5}}), HasSubstr("no effect"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"c0", 0}}), HasSubstr("E_b is 0"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"bending", "variational"}}), HasSubstr("E_b is 0"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"fluid", "transient"}, {"fidelity", {{"tolerance", 1e-4}}}}),
              HasSubstr("no effect"));
}

TEST(ParseCase, UnsteadyFlowHasOneStepperAndOneScheme) {
  const json base = {{"Ca", 0.1}, {"Re", 0.5}, {"fluid", "unsteady"}};
  EXPECT_THAT(only_message(with(base, "/fidelity", {{"stepper", "rkc2"}})), HasSubstr("once a step"));
  EXPECT_THAT(only_message(with(base, "/fidelity", {{"scheme", "paper"}})), HasSubstr("one scheme"));
  const Case c = valid(with(base, "/fidelity", "paper"));
  EXPECT_EQ(c.fidelity.stepper, Stepper::adams_bashforth);
  EXPECT_EQ(c.fidelity.scheme, Scheme::tuned);
}

TEST(ParseCase, AKeyWithoutEffectIsOneIssueWhateverItsValue) {
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"bending", "helfrich"}}), HasSubstr("no effect"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"c0", "unifrom"}}), HasSubstr("no effect"));
  EXPECT_THAT(pointers_of_issues(json::parse(R"({"Ca": 0.1, "fluid": "stokes",
    "fidelity": {"dx": -1, "kdt": -4, "tolerance": 5}})")),
              UnorderedElementsAre("/fidelity/dx", "/fidelity/kdt", "/fidelity/tolerance"));
}

TEST(ParseCase, AnInvalidVMakesNoToleranceUseless) {
  const json document = {{"Ca", 0.1}, {"V", -2}, {"fluid", "stokes"}, {"fidelity", {{"tolerance", 1e-3}}}};
  EXPECT_THAT(pointers_of_issues(document), ElementsAre("/V"));
}

TEST(ParseCase, MarksKeysWithoutEffectSoThatTheyCanBeLeftOut) {
  EXPECT_TRUE(parse_case({{"Ca", 0.1}, {"C", 5}}).issues.at(0).without_effect);
  EXPECT_FALSE(parse_case({{"Ca", -0.1}}).issues.at(0).without_effect);
}

TEST(ParseCase, KeysWithoutEffectCanBeDroppedAllAtOnce) {
  json object = json::parse(R"({"Ca": 0.1, "C": 5, "c0": 0, "bending": "variational", "fluid": "stokes",
    "fidelity": {"nodes": 642, "tolerance": 1e-5, "dx": 0.1}})");
  EXPECT_EQ(drop_keys_without_effect(object).size(), 5u);
  EXPECT_EQ(object, json::parse(R"({"Ca": 0.1, "fluid": "stokes", "fidelity": {"nodes": 642}})"));
}

TEST(ParseCase, AToleranceHasNoEffectWhereBoundaryIntegralsSolveNoEquation) {
  const json sphere = {{"Ca", 0.1}, {"fluid", "stokes"}, {"fidelity", {{"tolerance", 1e-5}}}};
  EXPECT_THAT(pointers_of_issues(sphere), ElementsAre("/fidelity/tolerance"));
  EXPECT_THAT(only_message(sphere), HasSubstr("has no effect: at V = 1"));
  EXPECT_EQ(valid(with(sphere, "/V", 4)).fidelity.tolerance, 1e-5);
  EXPECT_EQ(valid(with(sphere, "/fluid", "quasisteady")).fidelity.tolerance, 1e-5);
}

TEST(ParseCase, RefusesAToleranceBelowTheRoundingOfTheFlow) {
  const json drop = {{"Ca", 0.1}, {"V", 4}, {"fluid", "stokes"}, {"fidelity", {{"tolerance", 1e-7}}}};
  EXPECT_THAT(only_message(drop), HasSubstr("1e-06 at best: raise it"));
  const json lattice = with(drop, "/fluid", "quasisteady");
  EXPECT_THAT(only_message(lattice), HasSubstr("precision double"));
  EXPECT_EQ(valid(with(lattice, "/fidelity/precision", "double")).fidelity.tolerance, 1e-7);
  EXPECT_EQ(valid(with(drop, "/fidelity/tolerance", 1e-6)).fidelity.tolerance, 1e-6);
}

TEST(ParseCase, RefusesNumbersThatAreNotFinite) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const char* key : {"Ca", "V", "Re", "E_b"})
      EXPECT_THAT(pointers_of_issues(with(kRedBloodCell, (std::string("/") + key).c_str(), bad)),
                  Contains(std::string("/") + key));
}

TEST(ParseCase, RefusesAWordWhereANumberBelongsAndTheReverse) {
  EXPECT_THAT(only_message({{"Ca", "0.1"}}), HasSubstr("must be a number, is string"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"shape", 1}}), HasSubstr("must be one of: sphere"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"until", {{"classified", 1}}}}), HasSubstr("true or false"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"outputs", {{"checkpoint_every", 2.5}}}}),
              HasSubstr("whole number"));
}

TEST(ParseCase, SpheroidsNeedAnAspectOnTheirSideOfOne) {
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"shape", "oblate"}}), ElementsAre("/aspect"));
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"shape", "oblate"}, {"aspect", 2}}), ElementsAre("/aspect"));
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"shape", "prolate"}, {"aspect", 0.5}}),
              ElementsAre("/aspect"));
  EXPECT_EQ(valid({{"Ca", 0.1}, {"shape", "prolate"}, {"aspect", 2}}).aspect, 2);
}

TEST(ParseCase, SpontaneousCurvatureIsANumberOrTheInitialOne) {
  EXPECT_EQ(valid(with(kRedBloodCell, "/c0", -1.5)).c0, SpontaneousCurvature(-1.5));
  EXPECT_EQ(valid(with(kRedBloodCell, "/c0", "initial")).c0, SpontaneousCurvature(InitialCurvature{}));
  EXPECT_THAT(pointers_of_issues(with(kRedBloodCell, "/c0", "flat")), ElementsAre("/c0"));
}

/// The flow model that is chosen for a sphere with these keys; the same for "auto" and without the key
/// `fluid`.
Fluid chosen_fluid(json keys) {
  keys["Ca"] = 0.1;
  const Fluid by_default = valid(keys).fluid;
  keys["fluid"] = "auto";
  EXPECT_EQ(valid(keys).fluid, by_default) << keys;
  return by_default;
}

TEST(ParseCase, WithoutInertiaWallsAndLatticeSettingsTheFluidIsStokes) {
  for (const json& keys :
       {json::object(), json{{"Re", 0}}, json{{"Re", 0.1}}, json{{"V", 4}}, json{{"fidelity", "fast"}},
        json{{"fidelity", {{"nodes", 642}, {"symmetry", "none"}}}}})
    EXPECT_EQ(chosen_fluid(keys), Fluid::stokes) << keys;
}

TEST(ParseCase, ASettingThatOnlyALatticeHasAsksForALattice) {
  for (const json& fidelity :
       {json("paper"), json{{"preset", "paper"}}, json{{"dx", 0.1}}, json{{"box", 6.4}},
        json{{"scheme", "tuned"}}, json{{"precision", "double"}}, json{{"kdt", 0.01}}})
    EXPECT_EQ(chosen_fluid({{"fidelity", fidelity}}), Fluid::quasisteady) << fidelity;
}

TEST(ParseCase, InertiaAsksForAnUnsteadyFlow) {
  EXPECT_EQ(chosen_fluid({{"Re", 0.11}}), Fluid::unsteady);
  EXPECT_EQ(chosen_fluid({{"Re", 0.1}, {"fidelity", {{"box", 6.4}}}}), Fluid::unsteady);
  EXPECT_EQ(valid({{"Ca", 0.1}, {"Re", 0.1}, {"fluid", "quasisteady"}}).fluid, Fluid::quasisteady);
}

TEST(ParseCase, KeepsWhatWasAskedWhatWasChosenAndWhy) {
  const Choices choices = parse_case({{"Ca", 0.1}}).choices;
  ASSERT_EQ(choices.size(), 1u);
  EXPECT_EQ(choices[0].key, "fluid");
  EXPECT_EQ(choices[0].asked, "auto");
  EXPECT_EQ(choices[0].chosen, "stokes");
  EXPECT_THAT(choices[0].reason, HasSubstr("neither inertia (Re = 0) nor walls"));
  EXPECT_THAT(in_words(choices[0]), HasSubstr("fluid: auto became stokes: "));
  const ParsedCase lattice = parse_case({{"Ca", 0.1}, {"fidelity", {{"preset", "fast"}, {"dx", 0.4}}}});
  EXPECT_THAT(lattice.choices.at(0).reason, HasSubstr("fidelity/dx"));
}

TEST(ParseCase, SaysThatBoundaryIntegralsLeaveTheReynoldsNumberOut) {
  const Choices choices = parse_case({{"Ca", 0.1}, {"Re", 0.05}, {"fluid", "stokes"}}).choices;
  ASSERT_EQ(choices.size(), 1u);
  EXPECT_EQ(choices[0].key, "Re");
  EXPECT_EQ(choices[0].asked, 0.05);
  EXPECT_EQ(choices[0].chosen, 0);
  EXPECT_THAT(parse_case({{"Ca", 0.1}, {"fluid", "quasisteady"}}).choices, IsEmpty());
}

TEST(ParseCase, WhatAutoChoseIsTheCaseThatRuns) {
  EXPECT_EQ(case_id(valid({{"Ca", 0.1}, {"fluid", "auto"}})),
            case_id(valid({{"Ca", 0.1}, {"fluid", "stokes"}})));
}

TEST(ParseCase, StokesFlowHasNeitherInertiaNorGrid) {
  EXPECT_EQ(case_id(valid({{"Ca", 0.1}, {"fluid", "stokes"}, {"Re", 0.1}})),
            case_id(valid({{"Ca", 0.1}, {"fluid", "stokes"}, {"Re", 0}})));
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"fluid", "stokes"}, {"Re", 0.2}}), ElementsAre("/Re"));
  EXPECT_THAT(
      pointers_of_issues({{"Ca", 0.1}, {"fluid", "stokes"}, {"fidelity", {{"dx", 0.1}, {"box", 12.8}}}}),
      UnorderedElementsAre("/fidelity/dx", "/fidelity/box"));
}

TEST(ParseCase, ModelsThatNeedInertiaHaveThatOfThePaperAndOthersNone) {
  for (const char* fluid : {"stokes", "quasisteady"})
    EXPECT_EQ(valid({{"Ca", 0.1}, {"fluid", fluid}}).Re, 0) << fluid;
  for (const json& model :
       {json{{"fluid", "unsteady"}}, json{{"fluid", "transient"}}, json{{"fidelity", "paper"}},
        json{{"fidelity", {{"preset", "paper"}, {"dx", 0.2}}}},
        json{{"fluid", "quasisteady"}, {"fidelity", {{"scheme", "paper"}}}}}) {
    json file = {{"Ca", 0.1}, {"fidelity", "fast"}};
    file.update(model);
    EXPECT_EQ(valid(file).Re, 0.05) << file;
    file["Re"] = 0;
    EXPECT_THAT(pointers_of_issues(file), ElementsAre("/Re")) << file;
    file["Re"] = -1;
    EXPECT_THAT(pointers_of_issues(file), ElementsAre("/Re")) << file;
  }
  EXPECT_EQ(valid({{"Ca", 0.1}, {"fidelity", {{"preset", "paper"}, {"scheme", "tuned"}}}}).Re, 0);
  EXPECT_THAT(parse_case({{"Ca", 0.1}, {"fidelity", "paper"}}).choices.at(0).reason, HasSubstr("Re = 0.05"));
}

TEST(ParseCase, DomainIsWideOnACompositeGridAndThatOfThePaperElsewhere) {
  const auto box = [](json file) {
    file["Ca"] = 0.1;
    return valid(file).fidelity.box;
  };
  EXPECT_EQ(box({{"fluid", "quasisteady"}}), 25.6);
  EXPECT_EQ(box({{"fluid", "unsteady"}, {"fidelity", "fast"}}), 25.6);
  EXPECT_EQ(box({{"fluid", "transient"}, {"fidelity", {{"dx", 0.2}}}}), 12.8);
  EXPECT_EQ(box({{"fidelity", "paper"}}), 12.8);
  EXPECT_EQ(box({{"fluid", "quasisteady"}, {"fidelity", {{"dx", 0.2}, {"scheme", "paper"}}}}), 12.8);
  EXPECT_EQ(box({{"fluid", "quasisteady"}, {"fidelity", {{"dx", 0.2}, {"box", 6.4}}}}), 6.4);
}

TEST(ParseCase, StepperThatChoosesItsStepsTakesNone) {
  EXPECT_EQ(valid({{"Ca", 0.1}, {"fluid", "stokes"}}).fidelity.stepper, Stepper::runge_kutta_chebyshev);
  EXPECT_EQ(valid({{"Ca", 1}, {"fluid", "quasisteady"}, {"fidelity", "fast"}}).fidelity.stepper,
            Stepper::adams_bashforth);
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"fidelity", {{"stepper", "rkc2"}, {"kdt", 0.1}}}}),
              ElementsAre("/fidelity/kdt"));
}

TEST(ParseCase, AGridThatCannotBeCoarsenedOrHeldIsAnIssue) {
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"fidelity", {{"dx", 0.11}}}}), ElementsAre("/fidelity"));
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"fidelity", {{"dx", 0.02}, {"box", 100}}}}), HasSubstr("try 4096"));
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"fidelity", {{"dx", 0.025}, {"box", 51.2}}}}), IsEmpty());
}

TEST(ParseCase, OnlyAFlowThatHasTheChoiceTakesASymmetryOrAPrecision) {
  const Case c = valid({{"Ca", 0.1}, {"fidelity", {{"symmetry", "none"}, {"precision", "double"}}}});
  EXPECT_EQ(c.fidelity.symmetry, Symmetry::none);
  EXPECT_EQ(c.fidelity.precision, Precision::double_);
  EXPECT_EQ(valid({{"Ca", 0.1}, {"fluid", "stokes"}, {"fidelity", {{"symmetry", "none"}}}}).fidelity.symmetry,
            Symmetry::none);
  EXPECT_EQ(valid({{"Ca", 0.1}, {"fluid", "transient"}, {"fidelity", {{"precision", "double"}}}})
                .fidelity.precision,
            Precision::double_);
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"fidelity", {{"scheme", "paper"}, {"precision", "double"}}}}),
              ElementsAre("/fidelity/precision"));
  EXPECT_THAT(pointers_of_issues({{"Ca", 0.1}, {"fluid", "transient"}, {"fidelity", {{"symmetry", "none"}}}}),
              ElementsAre("/fidelity/symmetry"));
}

TEST(ParseCase, APresetIsAStartThatKnobsChange) {
  const Case c =
      valid({{"Ca", 0.1}, {"fluid", "quasisteady"}, {"fidelity", {{"preset", "fast"}, {"nodes", 162}}}});
  EXPECT_EQ(c.fidelity.dx, 0.2);
  EXPECT_EQ(c.fidelity.nodes, 162);
  EXPECT_THAT(only_message({{"Ca", 0.1}, {"fidelity", "quick"}}), HasSubstr("fast, standard, fine, paper"));
}

const json kManyCases[] = {
    kRedBloodCell,
    {{"Ca", 0.05}},
    {{"Ca", 0.05}, {"fluid", "quasisteady"}},
    with(kRedBloodCell, "/c0", 0.1),
    with(kRedBloodCell, "/bending", "helfrich_literal"),
    {{"Ca", 1.0 / 3}, {"shape", "oblate"}, {"aspect", 0.9}},
    {{"Ca", 0.1}, {"Re", 0.25}},
    {{"Ca", 0.1}, {"fidelity", "paper"}},
    {{"Ca", 0.1}, {"fluid", "unsteady"}, {"fidelity", "paper"}},
    {{"Ca", 0.1}, {"fluid", "transient"}, {"fidelity", {{"precision", "double"}}}},
    {{"Ca", 0.1}, {"fluid", "stokes"}, {"fidelity", "fine"}},
    {{"Ca", 0.1}, {"fluid", "stokes"}, {"fidelity", {{"stepper", "ab2"}}}},
    with(kRedBloodCell, "/c0", "uniform"),
};

TEST(CanonicalCase, ReadsBackAsTheSameCase) {
  for (const json& object : kManyCases) {
    const Case c = valid(object);
    EXPECT_EQ(valid(json(to_json(c))), c) << object;
    EXPECT_EQ(valid(*parse_json(to_json(c).dump()).value), c) << object;
  }
}

TEST(CanonicalCase, WritesOutEveryDefault) {
  const Case c = valid({{"Ca", 0.05}, {"fluid", "quasisteady"}});
  const nlohmann::ordered_json canonical = to_json(c);
  for (const char* key : {"shape", "law", "Ca", "V", "Re", "E_b", "fluid", "until", "fidelity", "outputs"})
    EXPECT_TRUE(canonical.contains(key)) << key;
  EXPECT_FALSE(canonical.contains("C"));  // without effect
}

TEST(CaseId, IsSharedByEqualCasesHoweverTheyAreWritten) {
  const Case written = valid(json::parse(R"({"Ca": 0.40, "V": 4.0e0, "law": "skalak", "C": 5.0, "E_b": 15e-3,
      "shape": "biconcave", "c0": "initial", "fluid": "quasisteady", "Re": 5e-2, "fidelity": "standard"})"));
  EXPECT_EQ(case_id(written), case_id(valid(kRedBloodCell)));
}

TEST(CaseId, IsChangedByEveryParameter) {
  const std::pair<const char*, json> changes[] = {{"/shape", "sphere"},
                                                  {"/C", 6},
                                                  {"/Ca", 0.41},
                                                  {"/V", 3},
                                                  {"/Re", 0.06},
                                                  {"/E_b", 0.016},
                                                  {"/bending", "helfrich_literal"},
                                                  {"/c0", 0},
                                                  {"/fluid", "transient"},
                                                  {"/fluid", "unsteady"},
                                                  {"/until/kt", 31},
                                                  {"/until/classified", true},
                                                  {"/until", {{"classified", true}, {"at_most", 50}}},
                                                  {"/fidelity/dx", 0.2},
                                                  {"/fidelity/box", 6.4},
                                                  {"/fidelity/nodes", 642},
                                                  {"/fidelity/kdt", 0.011},
                                                  {"/fidelity/tolerance", 1e-5},
                                                  {"/fidelity/scheme", "paper"},
                                                  {"/outputs/history_every", 0.2},
                                                  {"/outputs/shapes_every", 2},
                                                  {"/outputs/checkpoint_every", 7}};
  std::set<std::string> ids = {case_id(valid(kRedBloodCell))};
  for (const auto& [pointer, value] : changes)
    EXPECT_TRUE(ids.insert(case_id(valid(with(kRedBloodCell, pointer, value)))).second) << pointer;
  json neo_hookean = with(kRedBloodCell, "/law", "neo-hookean");
  neo_hookean.erase("C");
  EXPECT_TRUE(ids.insert(case_id(valid(neo_hookean))).second);
  const json oblate = {{"Ca", 0.1}, {"shape", "oblate"}, {"aspect", 0.5}};
  EXPECT_NE(case_id(valid(oblate)), case_id(valid(with(oblate, "/aspect", 0.6))));
}

TEST(StepsId, IsSharedByCasesThatDifferInTheEndOfTheRunOnly) {
  const std::string id = steps_id(valid(kRedBloodCell));
  const std::pair<const char*, json> ends[] = {{"/until", {{"classified", true}, {"kt", 7}, {"at_most", 50}}},
                                               {"/companion", false},
                                               {"/outputs/checkpoint_every", 7}};
  for (const auto& [pointer, value] : ends)
    EXPECT_EQ(steps_id(valid(with(kRedBloodCell, pointer, value))), id) << pointer;
  const std::pair<const char*, json> others[] = {
      {"/Ca", 0.41}, {"/fidelity/nodes", 642}, {"/outputs/history_every", 0.2}, {"/outputs/shapes_every", 2}};
  for (const auto& [pointer, value] : others)
    EXPECT_NE(steps_id(valid(with(kRedBloodCell, pointer, value))), id) << pointer;
}

TEST(Until, PassesEarlierEndsUnlessALabelMightHaveEndedItBefore) {
  const Until plain{.kt = 20}, classified{.kt = 20, .classified = true, .at_most = 60};
  EXPECT_TRUE(passes_end_of({.kt = 10}, 10, plain));
  EXPECT_FALSE(passes_end_of({.kt = 30}, 30, plain));
  EXPECT_FALSE(passes_end_of({.kt = 10}, 10, classified));
  EXPECT_TRUE(passes_end_of({.kt = 10, .classified = true, .at_most = 30}, 14, classified));
  EXPECT_TRUE(passes_end_of({.kt = 50, .classified = true, .at_most = 150}, 7, classified));
  EXPECT_TRUE(passes_end_of({.kt = 50, .classified = true, .at_most = 150}, 7, plain));
  EXPECT_FALSE(passes_end_of({.kt = 10, .classified = true, .at_most = 30}, 30, classified));
  EXPECT_TRUE(passes_end_of({.kt = 20, .classified = true, .at_most = 40}, 40, classified));
  EXPECT_FALSE(passes_end_of({.kt = 20, .classified = true, .at_most = 80}, 80, classified));
}

TEST(CaseId, IsSixteenHexadecimalDigits) {
  EXPECT_THAT(case_id(valid(kRedBloodCell)), ::testing::MatchesRegex("[0-9a-f]{16}"));
}

TEST(Sha256, OfAbcIsThatOfTheStandard) {
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(ParseJson, RefusesTextsNestedSoDeepThatTheyWouldBreakTheStack) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  const ParsedJson parsed = parse_json(deep);
  EXPECT_FALSE(parsed.value);
  ASSERT_EQ(parsed.issues.size(), 1u);
  EXPECT_THAT(parsed.issues[0].message, HasSubstr("deeper than 32"));
  EXPECT_TRUE(parse_json(std::string(32, '[') + std::string(32, ']')).value);
}

TEST(ParseJson, BracketsInsideStringsAreNoDepth) {
  EXPECT_TRUE(parse_json("[\"" + std::string(1000, '[') + "\\\"[[\"]").value);
}

TEST(ParseJson, RefusesNumbersThatOverflowAndWordsThatAreNoNumbers) {
  for (const char* text : {R"({"Ca": 1e999})", R"({"Ca": NaN})", R"({"Ca": Infinity})"}) {
    const ParsedJson parsed = parse_json(text);
    EXPECT_FALSE(parsed.value) << text;
    EXPECT_EQ(parsed.issues.size(), 1u) << text;
  }
}

TEST(ParseJson, RefusesAKeyThatStandsTwice) {
  EXPECT_THAT(parse_json(R"({"Ca": 0.1, "Ca": 0.2})").issues.at(0).message, HasSubstr("\"Ca\" stands twice"));
  EXPECT_THAT(parse_json(R"({"a": {"x": 1}, "b": {"x": 1}})").issues, IsEmpty());
}

TEST(ParseJson, RefusesATextCutAnywhere) {
  const std::string text = kRedBloodCell.dump();
  for (size_t length = 0; length < text.size(); ++length)
    EXPECT_FALSE(parse_json(text.substr(0, length)).value) << length;
}

TEST(ContentId, NegativeZeroIsZero) {
  const auto id = [](const char* text) { return case_id(parse_case(json::parse(text)).value.value()); };
  EXPECT_EQ(id(R"({"Ca": 0.1, "E_b": -0.0, "outputs": {"shapes_every": -0.0}})"),
            id(R"({"Ca": 0.1, "E_b": 0, "outputs": {"shapes_every": 0}})"));
  EXPECT_EQ(id(R"({"Ca": 0.1, "E_b": 0.01, "c0": -0.0})"), id(R"({"Ca": 0.1, "E_b": 0.01, "c0": 0})"));
}

}  // namespace
}  // namespace capstan
