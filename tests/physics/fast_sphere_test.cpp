// The accuracy of fidelity `fast`: a neo-Hookean sphere against boundary integrals and linear theory. The box
// of 12.8 a adds up to 1 %.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/reference/neo_hookean_sphere.hpp"
#include "tests/support/sphere_run.hpp"
#include "tests/support/test_names.hpp"

namespace capstan {
namespace {

class FastSphere : public ::testing::TestWithParam<double> {};

TEST_P(FastSphere, DeformsWithinTwoPercentOfBoundaryIntegrals) {
  const auto& exact = reference::neo_hookean_sphere(GetParam());
  const History history = testing::sphere_run(GetParam(), R"("fast")", 3);
  for (std::size_t i = 0; i < exact.D_xy_at.size(); ++i)
    EXPECT_NEAR(testing::at(history, reference::kTimes[i])["D_xy"], exact.D_xy_at[i], 0.02 * exact.D_xy_at[i])
        << "kt = " << reference::kTimes[i];
  EXPECT_NEAR(history.back()["theta"] / std::numbers::pi, exact.theta_over_pi, 0.01);
  EXPECT_NEAR(history.back()["volume"] / history.front()["volume"], 1, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Spheres, FastSphere, ::testing::Values(0.05, 0.1), testing::number_names("Ca"));

// Linear theory for Ca -> 0: D = 25/4 Ca, and the membrane turns with the vorticity, k/2.
TEST(FastSphere, NearlyRoundFollowsTheLinearLawAndTankTreadsAtHalfTheShearRate) {
  const double Ca = 0.0125;
  const History history = testing::sphere_run(Ca, R"("fast")", 1.6);
  const Record last = history.back(), before = testing::at(history, 1.1);
  EXPECT_NEAR(last["D_xy"], 25.0 / 4 * Ca, 0.03 * 25.0 / 4 * Ca);
  EXPECT_NEAR((before["psi"] - last["psi"]) / (last["kt"] - before["kt"]), 0.5, 0.03);
}

}  // namespace
}  // namespace capstan
