// Refinement of a grid on synthetic phase diagrams.
#include "runner/boundary/next_corners.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/unit/boundary/synthetic_map.hpp"

namespace capstan {
namespace {

RefinedGrid coarse_grid() { return {{{{0, 0.25, 0.5, 0.75, 1}, {1, 2, 3, 4, 5}}}, {0.02, 0.25}, {}}; }

/// Tumbling below Ca = 0.1 + V / 8, tank-treading above.
SyntheticMap straight() {
  return {"straight", [](double Ca, double V) { return Ca < 0.1 + V / 8 ? 0.3 : -0.3; }};
}

void compute(RefinedGrid& grid, const SyntheticMap& map, const std::vector<Corner>& corners) {
  for (const Corner& corner : corners) grid.points[corner] = computed_point(map, corner[0], corner[1]);
}

RefinedGrid refined(const SyntheticMap& map) {
  RefinedGrid grid = coarse_grid();
  for (const double Ca : grid.values[0])
    for (const double V : grid.values[1]) compute(grid, map, {{Ca, V}});
  for (std::vector<Corner> next = next_corners(grid); !next.empty(); next = next_corners(grid))
    compute(grid, map, next);
  return grid;
}

/// The nearest computed points to the left and to the right of a place in a row.
double gap_at(const RefinedGrid& grid, double V, double Ca) {
  double low = -1, high = 2;
  for (const auto& [corner, point] : grid.points) {
    if (corner[1] != V) continue;
    if (corner[0] < Ca)
      low = std::max(low, corner[0]);
    else
      high = std::min(high, corner[0]);
  }
  return high - low;
}

TEST(NextCorners, EncloseTheBoundaryInCellsOfTheSidesAskedFor) {
  const RefinedGrid grid = refined(straight());
  for (double V = 1; V <= 5; V += 0.25) EXPECT_LE(gap_at(grid, V, 0.1 + V / 8), 0.02) << V;
}

TEST(NextCorners, AreLessThanAQuarterOfTheUniformGrid) {
  const double uniform = (1 / 0.02 + 1) * (4 / 0.25 + 1);
  EXPECT_LT(double(refined(straight()).points.size()), uniform / 4);
}

TEST(NextCorners, AreNoneWhereAllCornersHaveOneLabel) {
  EXPECT_EQ(refined({"tumbling", [](double, double) { return 0.3; }}).points.size(), 25u);
}

TEST(NextCorners, AreNoneForACellWithACornerThatHasNotEnded) {
  RefinedGrid grid = coarse_grid();
  grid.values = {{{0, 1}, {1, 5}}};
  compute(grid, straight(), {{0, 1}, {1, 1}, {0, 5}, {1, 5}});
  EXPECT_THAT(next_corners(grid), ::testing::SizeIs(5));
  grid.points[{0, 1}].has_ended = false;
  EXPECT_THAT(next_corners(grid), ::testing::IsEmpty());
}

TEST(NextCorners, PassOverPointsWithoutALabel) {
  SyntheticMap map = straight();
  map.share_failed = 1;
  EXPECT_EQ(refined(map).points.size(), 25u);
}

}  // namespace
}  // namespace capstan
