#include "solver/simulation/membrane_state.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

/// x = kt^3 - kt, y = kt^2, z = 1; forces (kt, 0, 1).
MembraneState cubic_motion(double kt) {
  MembraneState state{
      .kt = kt, .positions = Points(3, 1), .velocities = Points(3, 1), .forces = Points(3, 1)};
  state.positions << kt * kt * kt - kt, kt * kt, 1;
  state.velocities << 3 * kt * kt - 1, 2 * kt, 0;
  state.forces << kt, 0, 1;
  return state;
}

TEST(MembraneState, BetweenTwoStepsIsExactForCubicMotion) {
  const MembraneState a = cubic_motion(0.3), b = cubic_motion(0.7);
  for (double kt : {0.3, 0.37, 0.5, 0.66, 0.7}) {
    const MembraneState found = between(a, b, kt), exact = cubic_motion(kt);
    EXPECT_EQ(found.kt, kt);
    EXPECT_LT((found.positions - exact.positions).norm(), 1e-15);
    EXPECT_LT((found.velocities - exact.velocities).norm(), 1e-14);
    EXPECT_LT((found.forces - exact.forces).norm(), 1e-15);
  }
}

}  // namespace
}  // namespace capstan
