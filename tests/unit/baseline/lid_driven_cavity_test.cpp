#include "solver/baseline/lid_driven_cavity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "solver/grid/full_approximation.hpp"

namespace capstan {
namespace {

constexpr double kLid = 1e-3;

std::vector<CavityGrid> solved(int cells, int cycles) {
  std::vector<CavityGrid> grids = make_cavity_grids(cells, {.lid_speed = kLid, .inertia = 0});
  for (int cycle = 0; cycle < cycles; ++cycle) fas_cycle(std::span(grids), {});
  return grids;
}

TEST(LidDrivenCavity, CyclesLeadToTheSameFlowAsRelaxationAlone) {
  CavityGrid relaxed(8, {.lid_speed = kLid, .inertia = 0});
  for (int sweep = 0; sweep < 8000; ++sweep) relaxed.relax();
  EXPECT_LT(relative_difference(solved(8, 150).front().velocity(), relaxed.velocity()), 1e-6);
}

TEST(LidDrivenCavity, NoFluidIsLost) { EXPECT_NEAR(solved(16, 30).front().excess_mass(), 0, 1e-9); }

TEST(LidDrivenCavity, FluidFollowsTheLidAndReturnsBelow) {
  const VectorField u = solved(16, 100).front().velocity();
  double flux = 0;
  for (int y = 0; y < 16; ++y)
    for (int z = 0; z < 16; ++z) flux += u.row(0, y, z)[8];
  EXPECT_GT(u.row(0, 15, 8)[8], 0.7 * kLid);
  EXPECT_LT(u.row(0, 8, 8)[8], 0);
  // Not closer to 0: the lid adds momentum to populations as it reflects them, which carries no mass.
  EXPECT_NEAR(flux, 0, 0.02 * kLid * 256);
}

TEST(LidDrivenCavity, WithoutInertiaTheFlowIsSymmetric) {
  const VectorField u = solved(16, 60).front().velocity();
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 8; ++x) {
      EXPECT_NEAR(u.row(0, y, 5)[x], u.row(0, y, 5)[15 - x], 1e-6 * kLid);
      EXPECT_NEAR(u.row(0, y, 5)[x], u.row(0, y, 10)[x], 1e-6 * kLid);
    }
}

TEST(LidDrivenCavity, ASmallerToleranceTakesMoreCyclesAndStrongRelaxationFewer) {
  const CavityCycles weak = count_cavity_cycles(16, 0.05, 0.3, {1e-3, 1e-5}, 500);
  const CavityCycles strong = count_cavity_cycles(16, 0.05, 0.8, {1e-3, 1e-5}, 500);
  ASSERT_TRUE(weak.until[1] && strong.until[1]);
  EXPECT_LT(*strong.until[0], *strong.until[1]);
  EXPECT_LT(*strong.until[1], *weak.until[1]);
}

TEST(LidDrivenCavity, ReportsAToleranceThatIsNotReached) {
  EXPECT_FALSE(count_cavity_cycles(8, 0.05, 0.8, {1e-8}, 2).until[0]);
}

}  // namespace
}  // namespace capstan
