#include "solver/simulation/remedy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::parsed_case;

constexpr SurfaceQuality kSmooth{.largest_dihedral = 15, .folded_edges = 0, .smallest_angle = 30};
constexpr SurfaceQuality kFolded{.largest_dihedral = 170, .folded_edges = 0.1, .smallest_angle = 20};
constexpr SurfaceQuality kCollapsed{.largest_dihedral = 40, .folded_edges = 0, .smallest_angle = 1};

TEST(Remedy, ForAFailedMotionWithAb2IsTheOtherStepperOrAShorterStep) {
  const Case c = parsed_case(
      R"({"Ca": 0.1, "E_b": 1, "fluid": "quasisteady", "fidelity": {"preset": "fast", "kdt": 0.04}})");
  EXPECT_THAT(remedy(c, kSmooth, true),
              AllOf(HasSubstr("rkc2"), HasSubstr("a kdt of 0.00"), Not(HasSubstr("dx"))));
  EXPECT_EQ(remedy(c, kSmooth, false), "");
  EXPECT_EQ(remedy(c, kFolded, true), remedy(c, kSmooth, true));  // the folds are a consequence of the step
}

TEST(Remedy, ForAQuasisteadyFlowWithInertiaIsTheUnsteadyFlow) {
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 0.1, "Re": 1, "fluid": "quasisteady"})"), kFolded, true),
              HasSubstr("take the fluid unsteady"));
}

TEST(Remedy, ForFoldsIsBendingStiffness) {
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 0.4})"), kFolded, true),
              AllOf(HasSubstr("folded"), HasSubstr("raise E_b to 0.005")));
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 0.4, "E_b": 0.01})"), kFolded, true),
              HasSubstr("raise E_b to 0.03"));
}

TEST(Remedy, ForCollapsedTrianglesIsResistanceToCompression) {
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 1, "law": "skalak", "C": 0})"), kCollapsed, true),
              HasSubstr("raise C"));
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 1})"), kCollapsed, true), HasSubstr("collapsed"));
}

TEST(Remedy, ForTheTransientFlowIsASofterMembrane) {
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 0.1, "Re": 5, "fluid": "transient"})"), kSmooth, true),
              HasSubstr("raise Ca"));
}

TEST(Remedy, ForTheUnsteadyFlowIsAShorterStepAndNotRkc2) {
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 0.1, "Re": 5, "fluid": "unsteady"})"), kSmooth, true),
              AllOf(HasSubstr("take a kdt of"), Not(HasSubstr("rkc2"))));
}

TEST(Remedy, ForALowInnerViscosityInStokesFlowIsALatticeOrMoreViscosity) {
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 1, "V": 0.01, "fluid": "stokes"})"), kSmooth, true),
              AllOf(HasSubstr("take the fluid quasisteady"), HasSubstr("raise V")));
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 1, "V": 1, "fluid": "stokes"})"), kSmooth, true),
              HasSubstr("raise Ca"));
}

TEST(Remedy, ForAThinInsideWithInertiaIsASmallerReOrALargerV) {
  EXPECT_THAT(
      remedy(parsed_case(R"({"Ca": 0.1, "V": 0.01, "Re": 0.5, "fluid": "unsteady", "fidelity": "standard"})"),
             kSmooth, true),
      AllOf(HasSubstr("Re/V = 50"), HasSubstr("lower Re, or raise V")));
}

// No lattice holds it: the capsule outgrows every box.
TEST(Remedy, ForANeoHookeanCapsuleThatIsDrawnOutIsASmallerCaOrALawThatHardens) {
  for (const char* V : {"0.01", "1"})
    EXPECT_THAT(
        remedy(parsed_case(std::string(R"({"Ca": 4, "fluid": "stokes", "V": )") + V + "}"), kSmooth, true),
        AllOf(HasSubstr("lower Ca to 1"), HasSubstr("skalak"), Not(HasSubstr("quasisteady"))));
}

TEST(Remedy, ExistsForEveryFailedMotion) {
  EXPECT_THAT(remedy(parsed_case(R"({"Ca": 0.01, "E_b": 1, "c0": -20})"), kSmooth, true),
              HasSubstr("lower E_b, C or c0"));
}

TEST(LostSurface, IsFoldedOrCollapsedOrNotANumber) {
  EXPECT_FALSE(is_lost(kSmooth));
  EXPECT_TRUE(is_lost(kFolded));
  EXPECT_TRUE(is_lost(kCollapsed));
  EXPECT_TRUE(is_lost({.largest_dihedral = std::nan(""), .folded_edges = 0, .smallest_angle = 30}));
}

TEST(VolumeDrift, IsANumberOnlyIfItIsFiniteAndNotHuge) {
  EXPECT_EQ(volume_drift_in_words(-0.41), "the volume has drifted by -41 %");
  EXPECT_THAT(volume_drift_in_words(1e30), HasSubstr("more than 1000 %"));
  EXPECT_THAT(volume_drift_in_words(-INFINITY), HasSubstr("not finite"));
  EXPECT_THAT(volume_drift_in_words(NAN), HasSubstr("not finite"));
}

}  // namespace
}  // namespace capstan
