// The accuracy of the lattice at fidelity `standard`: a neo-Hookean sphere against boundary integrals. The
// coupling is of second order in dx = 0.1; the box of 12.8 a adds 0.5 %.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/reference/neo_hookean_sphere.hpp"
#include "tests/support/sphere_run.hpp"

namespace capstan {
namespace {

/// Runs to `end` and compares D_xy at the times of the reference.
History expect_deformation(double Ca, double end) {
  constexpr double kBand = 0.015;  // relative
  const auto& exact = reference::neo_hookean_sphere(Ca);
  const History history = testing::sphere_run(Ca, R"("standard")", end);
  for (std::size_t i = 0; i < exact.D_xy_at.size() && reference::kTimes[i] <= end; ++i)
    EXPECT_NEAR(testing::at(history, reference::kTimes[i])["D_xy"] / exact.D_xy_at[i], 1, kBand)
        << "kt = " << reference::kTimes[i];
  return history;
}

// Measured: 0.0751, 0.0785 at kt = 0.5, 1.
TEST(StandardSphere, AtCapillaryNumberOneEightiethDeformsWithinOneAndAHalfPercent) {
  expect_deformation(0.0125, 1);
}

// Measured: 0.1700, 0.2350, 0.2688, 0.2729 at kt = 0.5, 1, 2, 3; theta 0.1738 pi.
TEST(StandardSphere, AtCapillaryNumberOneTwentiethDeformsWithinOneAndAHalfPercent) {
  const History history = expect_deformation(0.05, 3);
  EXPECT_NEAR(history.back()["theta"] / std::numbers::pi, 0.172, 0.003);
}

// Measured: 0.2027, 0.3129, 0.3890, 0.4018 at kt = 0.5, 1, 2, 3; theta 0.1421 pi at kt = 4.
TEST(StandardSphere, AtCapillaryNumberOneTenthDeformsWithinOneAndAHalfPercent) {
  const History history = expect_deformation(0.1, 4);
  EXPECT_NEAR(history.back()["theta"] / std::numbers::pi, 0.140, 0.003);
}

}  // namespace
}  // namespace capstan
