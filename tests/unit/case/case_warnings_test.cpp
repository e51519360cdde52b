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
  for (const char* fluid : {"stokes", "quasisteady", "transient"})
    for (const char* preset : {"fast", "standard"})
      EXPECT_THAT(warnings_of(std::string(R"("fluid": ")") + fluid + R"(", "fidelity": ")" + preset + "\""),
                  IsEmpty());
  EXPECT_THAT(warnings_of(R"("fidelity": "paper")"), IsEmpty());
}

TEST(CaseWarnings, AQuasisteadyFlowAtAReynoldsNumberThatIsNotSmallSaysWhichFluidToUse) {
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "Re": 0.2)"),
              ElementsAre(AllOf(HasSubstr("Re = 0.2"), HasSubstr("\"fluid\": \"transient\""))));
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "Re": 0.09)"), IsEmpty());
}

TEST(CaseWarnings, ALatticeFinerThanTheMeshSaysWhatToChange) {
  for (const char* fluid : {"quasisteady", "transient"})
    EXPECT_THAT(
        warnings_of(std::string(R"("fluid": ")") + fluid + R"(", "fidelity": {"dx": 0.05, "nodes": 642})"),
        ElementsAre(AllOf(HasSubstr("finer than the membrane's mesh"), HasSubstr("more nodes"),
                          HasSubstr("dx of at least 0.075"))));
  EXPECT_THAT(warnings_of(R"("fidelity": {"dx": 0.1, "nodes": 162})"),
              ElementsAre(HasSubstr("at least 0.15")));
  EXPECT_THAT(warnings_of(R"("fidelity": {"dx": 0.1, "nodes": 642})"), IsEmpty());
}

TEST(CaseWarnings, AViscousInsideOnACoarseLatticeSaysHowFarOffAndWhatToUse) {
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "V": 10, "fidelity": "fast")"),
              ElementsAre(AllOf(HasSubstr("V = 10"), HasSubstr("18 %"), HasSubstr("\"fluid\": \"stokes\""),
                                HasSubstr("dx of at most 0.11"))));
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "V": 100, "fidelity": "fast")"),
              ElementsAre(AllOf(HasSubstr("V = 100"), HasSubstr("180 %"), Not(HasSubstr("dx of at most")))));
  EXPECT_THAT(warnings_of(R"("fluid": "quasisteady", "V": 10, "fidelity": "standard")"), IsEmpty());
  EXPECT_THAT(warnings_of(R"("fluid": "stokes", "V": 100, "fidelity": "fast")"), IsEmpty());
}

}  // namespace
}  // namespace capstan
