#include "solver/case/case_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> warnings_of(const std::string& keys) {
  return case_warnings(testing::parsed_case(R"({"Ca": 0.2, )" + keys + "}"));
}

TEST(CaseWarnings, ThereAreNoneForThePresetsAsTheyAre) {
  for (const char* fluid : {"stokes", "quasisteady", "unsteady", "transient"})
    for (const char* preset : {"fast", "standard"})
      EXPECT_THAT(warnings_of(std::string(R"("fluid": ")") + fluid + R"(", "fidelity": ")" + preset + "\""),
                  IsEmpty());
  EXPECT_THAT(warnings_of(R"("fidelity": "paper")"), IsEmpty());
}

TEST(CaseWarnings, AQuasisteadyFlowAtAReynoldsNumberThatIsNotSmallSaysWhichFluidToUse) {
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "Re": 0.2)"),
              ElementsAre(AllOf(HasSubstr("Re = 0.2"), HasSubstr("\"fluid\": \"unsteady\""))));
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "Re": 0.09)"), IsEmpty());
}

TEST(CaseWarnings, ALatticeFinerThanTheMeshSaysWhatToChange) {
  for (const char* fluid : {"quasisteady", "unsteady", "transient"})
    EXPECT_THAT(
        warnings_of(std::string(R"("fluid": ")") + fluid + R"(", "fidelity": {"dx": 0.05, "nodes": 642})"),
        ElementsAre(AllOf(HasSubstr("finer than the membrane's mesh"), HasSubstr("more nodes"),
                          HasSubstr("dx of at least 0.075"))));
  EXPECT_THAT(warnings_of(R"("fidelity": {"dx": 0.1, "nodes": 162})"),
              ElementsAre(HasSubstr("at least 0.15")));
  EXPECT_THAT(warnings_of(R"("fidelity": {"dx": 0.1, "nodes": 642})"), IsEmpty());
}

TEST(CaseWarnings, AViscousInsideOnACoarseLatticeSaysHowFarOffAndWhatToUse) {
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "V": 30, "fidelity": {"dx": 0.4, "nodes": 162})"),
              ElementsAre(AllOf(HasSubstr("V = 30"), HasSubstr("13 %"), HasSubstr("\"fluid\": \"stokes\""),
                                HasSubstr("dx of at most 0.376")),
                          HasSubstr("outside 0.1 to 20")));
  EXPECT_THAT(
      warnings_of(R"("fluid": "quasisteady", "V": 100, "fidelity": {"dx": 0.4, "nodes": 162})"),
      ElementsAre(AllOf(HasSubstr("V = 100"), HasSubstr("22 % too large"), HasSubstr("dx of at most 0.258")),
                  HasSubstr("outside 0.1 to 20")));
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "V": 20, "fidelity": "fast")"), IsEmpty());
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "V": 10, "fidelity": {"preset": "paper", "dx": 0.2})"),
              ElementsAre(HasSubstr("18 %")));
  EXPECT_THAT(warnings_of(R"("fluid": "stokes", "V": 100, "fidelity": "fast")"),
              ElementsAre(HasSubstr("outside 0.1 to 20")));
}

std::vector<std::string> warnings_at(double Ca, const std::string& keys) {
  Case c = testing::parsed_case(R"({"Ca": 1, )" + keys + "}");
  c.Ca = Ca;
  return case_warnings(c);
}

TEST(CaseWarnings, ANarrowBoxSaysHowMuchItsWallsChange) {
  const auto box = [](const std::string& size) {
    return warnings_of(R"("fluid": "quasisteady", "fidelity": {"dx": 0.2, "nodes": 642, "box": )" + size +
                       "}");
  };
  EXPECT_THAT(box("6.4"), ElementsAre(AllOf(HasSubstr("a box of 6.4 a"), HasSubstr("0.014 to 0.28"))));
  EXPECT_THAT(box("12.8"), IsEmpty());
  EXPECT_THAT(warnings_of(R"("fluid": "stokes")"), IsEmpty());
}

TEST(CaseWarnings, NumbersBeyondTheMeasuredOnesAreNamed) {
  EXPECT_THAT(warnings_at(0.009, R"("E_b": 0.01)"),
              ElementsAre(HasSubstr("Ca = 0.009 is outside 0.01 to 2")));
  EXPECT_THAT(warnings_at(2.1, R"("E_b": 0.01, "V": 0.05)"),
              ElementsAre(HasSubstr("Ca = 2.1 is outside 0.01 to 2 and V = 0.05 is outside 0.1 to 20")));
  EXPECT_THAT(warnings_at(2, R"("E_b": 0.01, "V": 20)"), IsEmpty());
}

TEST(CaseWarnings, AThinInsideWithInertiaSaysByHowMuchAndWhatToUse) {
  const auto is_unstable = ::testing::Contains(HasSubstr("likely to become unstable"));
  EXPECT_THAT(warnings_of(R"("fluid": "unsteady", "V": 0.03, "Re": 0.6, "fidelity": "fast")"),
              ::testing::Contains(AllOf(HasSubstr("Re/V = 20"), HasSubstr("smaller Re or a larger V"))));
  EXPECT_THAT(warnings_of(R"("fluid": "unsteady", "V": 0.1, "Re": 0.6, "fidelity": "fast")"),
              Not(is_unstable));
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "V": 0.01, "fidelity": "standard")"), Not(is_unstable));
  EXPECT_THAT(warnings_of(R"("fluid": "stokes", "V": 0.01, "fidelity": "standard")"), Not(is_unstable));
}

std::vector<std::string> warnings_of_shape(const std::string& keys) {
  return case_warnings(testing::parsed_case("{" + keys + "}"));
}

TEST(CaseWarnings, AMembraneThatWillWrinkleNamesABendingStiffness) {
  const auto wrinkles = [](const char* E_b) {
    return ElementsAre(AllOf(HasSubstr("wrinkles"), HasSubstr(E_b)));
  };
  EXPECT_THAT(warnings_of_shape(R"("shape": "biconcave", "Ca": 0.1)"), wrinkles("E_b = 0.005"));
  EXPECT_THAT(warnings_of_shape(R"("shape": "oblate", "aspect": 0.5, "Ca": 0.1)"), wrinkles("E_b = 0.005"));
  EXPECT_THAT(warnings_of_shape(R"("Ca": 0.0125)"), wrinkles("E_b = 0.0001"));
  EXPECT_THAT(warnings_of_shape(R"("Ca": 0.0125, "E_b": 0.0001)"), IsEmpty());
}

TEST(CaseWarnings, AMembraneThatStaysSmoothIsNotSaidToWrinkle) {
  for (const char* keys :
       {R"("Ca": 0.1)", R"("Ca": 0.0125, "V": 10)", R"("Ca": 0.0125, "until": {"kt": 2})",
        R"("shape": "biconcave", "Ca": 0.1, "V": 20)", R"("shape": "oblate", "aspect": 0.9, "Ca": 0.1)",
        R"("shape": "prolate", "aspect": 1.5, "Ca": 0.5)"})
    EXPECT_THAT(warnings_of_shape(keys), IsEmpty()) << keys;
}

}  // namespace
}  // namespace capstan
