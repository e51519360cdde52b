// The table of parameters and what is made from it.
#include "solver/case/parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "solver/case/parse.hpp"

namespace capstan {
namespace {

using nlohmann::json;

Case parsed(const json& document) { return parse_case(document).value.value(); }

/// Cases in which every parameter has an effect in one and none in another.
const json kCases[] = {{{"Ca", 0.1}},
                       {{"Ca", 0.1}, {"V", 4}, {"E_b", 0.01}, {"shape", "oblate"}, {"aspect", 0.5}},
                       {{"Ca", 0.1}, {"law", "skalak"}, {"C", 1}, {"fluid", "quasisteady"}},
                       {{"Ca", 0.1}, {"fluid", "quasisteady"}, {"fidelity", "paper"}},
                       {{"Ca", 0.1}, {"fluid", "transient"}},
                       {{"Ca", 0.1}, {"fidelity", {{"error", 0.01}}}},
                       {{"Ca", 0.1}, {"until", {{"classified", true}}}}};

TEST(Parameters, HaveDifferentPointersAndAreDescribed) {
  std::set<std::string> pointers;
  for (const Parameter& parameter : parameters()) {
    EXPECT_TRUE(pointers.insert(parameter.pointer()).second) << parameter.pointer();
    EXPECT_FALSE(parameter.description.empty()) << parameter.pointer();
  }
}

TEST(Parameters, StandInTheCanonicalFormWhereTheyHaveAnEffect) {
  for (const json& document : kCases) {
    const Case c = parsed(document);
    const json canonical = to_json(c);
    for (const Parameter& parameter : parameters())
      EXPECT_EQ(canonical.contains(json::json_pointer(parameter.pointer())), parameter.has_effect(c))
          << parameter.pointer() << " " << document;
  }
}

TEST(Parameters, ThatHaveNoEffectAreRefusedWithTheReasonOfTheirCondition) {
  const Case other = parsed({{"Ca", 0.1}, {"V", 4}, {"E_b", 0.01}, {"shape", "oblate"}, {"aspect", 0.5}});
  const std::set<std::string> given_anywhere = {"Re", "C", "error"};
  for (const json& document : kCases) {
    const Case c = parsed(document);
    for (const Parameter& parameter : parameters()) {
      if (parameter.has_effect(c) || given_anywhere.contains(parameter.key)) continue;
      json with = to_json(c);
      with[json::json_pointer(parameter.pointer())] = parameter.value->write(other);
      const Issues issues = parse_case(with).issues;
      ASSERT_EQ(issues.size(), 1u) << with;
      EXPECT_EQ(issues[0].pointer, parameter.pointer());
      EXPECT_TRUE(issues[0].without_effect);
    }
  }
}

TEST(Parameters, AllHaveAnEffectInSomeCaseAndConditionalOnesNoneInAnother) {
  for (const Parameter& parameter : parameters()) {
    const auto has_effect = [&](const json& document) { return parameter.has_effect(parsed(document)); };
    EXPECT_TRUE(std::ranges::any_of(kCases, has_effect)) << parameter.pointer();
    EXPECT_EQ(std::ranges::all_of(kCases, has_effect), parameter.conditions.empty()) << parameter.pointer();
  }
}

TEST(Words, OfEachEnumerationReadBackAsTheirValue) {
  const auto check = [](auto words) {
    for (const auto& [value, word] : words) {
      EXPECT_EQ(to_string(value), word);
      EXPECT_EQ(parse_word<std::remove_cvref_t<decltype(value)>>(word), value);
    }
  };
  check(kWords<Shape>);
  check(kWords<BendingModel>);
  check(kWords<Fluid>);
  check(kWords<Scheme>);
  check(kWords<Stepper>);
  check(kWords<Symmetry>);
  check(kWords<Precision>);
  EXPECT_EQ(parse_word<Shape>("cube"), std::nullopt);
}

}  // namespace
}  // namespace capstan
