// Inputs whose numbers are in range, one by one, and that cannot be run.
#include "solver/case/limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/case/parse.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Issues issues_of(const char* text) { return parse_case(json::parse(text)).issues; }

auto issue_at(const char* pointer, const char* words) {
  return Contains(AllOf(Field(&Issue::pointer, pointer), Field(&Issue::message, HasSubstr(words))));
}

TEST(Limits, TimesBelowTheirResolutionAreRefused) {
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "outputs": {"history_every": 1e-18}})"),
              issue_at("/outputs/history_every", "1e-06"));
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "outputs": {"shapes_every": 1e-18}})"),
              issue_at("/outputs/shapes_every", "1e-06"));
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "until": {"kt": 1e-18}})"), issue_at("/until/kt", "1e-06"));
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "fluid": "stokes", "fidelity": {"stepper": "ab2", "kdt": 1e-18}})"),
              issue_at("/fidelity/kdt", "1e-06"));
  EXPECT_THAT(
      issues_of(
          R"({"Ca": 0.1, "fluid": "transient", "Re": 1e-5, "until": {"kt": 0.1}, "fidelity": {"dx": 0.1}})"),
      issue_at("/Re", "raise Re or dx"));
}

TEST(Limits, RunsOfTooManyStepsAreRefusedWithTheKeyToChange) {
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "fluid": "transient", "Re": 1e-6})"), issue_at("/Re", "time steps"));
  EXPECT_THAT(
      issues_of(R"({"Ca": 0.1, "fluid": "stokes", "until": {"kt": 10000}, "outputs": {"history_every": 1},
                            "fidelity": {"stepper": "ab2", "kdt": 1e-6}})"),
      issue_at("/fidelity/kdt", "1e+10 time steps"));
}

TEST(Limits, ATransientFlowThatIsTooFastForItsLatticeOrItsMembraneIsRefused) {
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "fluid": "transient", "Re": 10, "fidelity": "fast"})"),
              issue_at("/Re", "lower Re, dx or box"));
  EXPECT_THAT(
      issues_of(
          R"({"Ca": 0.0017, "law": "skalak", "C": 134, "fluid": "transient", "Re": 3, "fidelity": "fast"})"),
      issue_at("/Ca", "raise Ca"));
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "fluid": "transient", "Re": 3, "fidelity": "fast"})"), IsEmpty());
}

TEST(Limits, RunsOfTooManyRecordsOrShapesAreRefused) {
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "until": {"kt": 10000}, "outputs": {"history_every": 1e-3}})"),
              issue_at("/outputs/history_every", "1e+07 records"));
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "outputs": {"shapes_every": 1e-5}})"),
              issue_at("/outputs/shapes_every", "3e+06 shapes"));
  EXPECT_THAT(
      issues_of(
          R"({"Ca": 0.1, "fluid": "stokes", "outputs": {"shapes_every": 1e-3}, "fidelity": {"nodes": 40962}})"),
      issue_at("/outputs/shapes_every", "GB of shapes"));
}

TEST(Limits, GridsThatDoNotFitIntoMemoryAreRefused) {
  for (const char* text :
       {R"({"Ca": 0.1, "fidelity": {"scheme": "paper", "dx": 0.02, "box": 20.48}, "fluid": "quasisteady"})",
        R"({"Ca": 0.1, "fluid": "transient", "fidelity": {"dx": 0.02, "box": 20.48}})"})
    EXPECT_THAT(issues_of(text), issue_at("/fidelity", "GB of memory")) << text;
}

TEST(Limits, RunsThatTakeMoreThanAYearAreRefused) {
  EXPECT_THAT(
      issues_of(
          R"({"Ca": 0.0001, "fluid": "stokes", "until": {"kt": 10000}, "fidelity": {"nodes": 40962, "symmetry": "none"}})"),
      issue_at("/until/kt", "days of computing"));
}

TEST(Limits, ABoxMustHoldTheCapsuleAsTheFlowDrawsItOut) {
  const char* prolate =
      R"({"Ca": 0.05, "fluid": "quasisteady", "shape": "prolate", "aspect": 5, "fidelity": {"dx": 0.1, "box": 4.8}})";
  EXPECT_THAT(issues_of(prolate), issue_at("/fidelity/box", "larger box"));
  EXPECT_THAT(issues_of(R"({"Ca": 1, "fluid": "transient", "fidelity": {"dx": 0.1, "box": 4.8}})"),
              issue_at("/fidelity/box", "larger box"));
  EXPECT_THAT(issues_of(R"({"Ca": 4, "fluid": "quasisteady", "fidelity": {"box": 12.8}})"),
              issue_at("/fidelity/box", "stokes"));
  EXPECT_THAT(
      issues_of(R"({"Ca": 4, "fluid": "quasisteady", "fidelity": {"box": 12.8}, "until": {"kt": 1}})"),
      IsEmpty());
  EXPECT_THAT(issues_of(R"({"Ca": 1, "fluid": "quasisteady"})"), IsEmpty());
}

TEST(Limits, ToleranceBelowTheRoundingOfTheGridIsRefused) {
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "fluid": "quasisteady", "fidelity": {"tolerance": 1e-12}})"),
              issue_at("/fidelity/tolerance", "precision double"));
  EXPECT_THAT(
      issues_of(
          R"({"Ca": 0.1, "fluid": "quasisteady", "fidelity": {"tolerance": 1e-12, "precision": "double"}})"),
      IsEmpty());
}

TEST(Limits, AllThatAreExceededAreReportedAtOnce) {
  EXPECT_EQ(issues_of(R"({"Ca": 0.1, "fluid": "stokes", "until": {"kt": 10000},
                          "outputs": {"history_every": 1e-3, "shapes_every": 1e-2}})")
                .size(),
            3u);
}

TEST(Limits, ThePapersCasesAndTheLongestRunAtTheDefaultsAreWithinThem) {
  for (const char* fluid : {"quasisteady", "unsteady", "transient", "stokes"})
    for (const char* fidelity : {"fast", "standard"})
      for (double Ca : {0.0125, 0.2, 1.0})
        EXPECT_THAT(parse_case({{"Ca", Ca}, {"fluid", fluid}, {"fidelity", fidelity}}).issues, IsEmpty())
            << fluid << Ca;
  EXPECT_THAT(issues_of(R"({"Ca": 0.1, "fluid": "stokes", "until": {"kt": 10000}, "fidelity": "fast"})"),
              IsEmpty());
}

}  // namespace
}  // namespace capstan
