#include "solver/grid/ghosts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace capstan {
namespace {

// A scalar and a vector.
constexpr ImageComponent kBehindWall[] = {{0, 1}, {1, -1}, {2, -1}, {3, -1}};
constexpr ImageComponent kMirrored[] = {{0, 1}, {1, 1}, {2, 1}, {3, -1}};
constexpr ImageComponent kTurned[] = {{0, 1}, {1, -1}, {2, -1}, {3, 1}};
constexpr Images kScalarAndVector = {kBehindWall, kMirrored, kTurned};

TEST(Ghosts, OfSymmetryPlanesAreTheImagesOfTheCells) {
  const IndexBox box{{-4, 0, 0}, {4, 3, 3}};
  const SideRules rules{{{{SideRule::periodic, SideRule::periodic},
                          {SideRule::half_turn, SideRule::interpolated},
                          {SideRule::mirror, SideRule::interpolated}}}};
  // A scalar and a vector that the half-turn about z and the mirror z -> -z leave unchanged
  const auto field = [](int k, double x, double y, double z) {
    const double values[] = {x * y + z * z, y * (1 + z * z), x * (1 - z * z), z * (1 + x * y)};
    return values[k];
  };
  RowField<double> moments(box, 4);
  const auto visit = [&](const IndexBox& cells, auto check) {
    for (int z = cells.lo[2]; z < cells.hi[2]; ++z)
      for (int y = cells.lo[1]; y < cells.hi[1]; ++y)
        for (int x = cells.lo[0]; x < cells.hi[0]; ++x)
          for (int k = 0; k < 4; ++k)
            check(moments.row(k, y, z)[x - box.lo[0]], field(k, x + 0.5, y + 0.5, z + 0.5));
  };
  visit(box, [](double& number, double value) { number = value; });
  fill_ghosts(moments, rules, kScalarAndVector);
  const IndexBox with_low_sides{{-4, -1, -1}, {4, 3, 3}};
  visit(with_low_sides, [](double number, double value) { EXPECT_DOUBLE_EQ(number, value); });
}

/// Two components that are each other's image behind a wall; periodic in x and z.
TEST(Ghosts, BetweenWallsArePermutedComponentsInEveryLayoutEdgesAndCornersIncluded) {
  constexpr ImageComponent kExchanged[] = {{1, 1}, {0, 1}};
  const IndexBox box = box_from_zero({3, 2, 4});
  const SideRules rules{{{{SideRule::periodic, SideRule::periodic},
                          {SideRule::wall, SideRule::wall},
                          {SideRule::periodic, SideRule::periodic}}}};
  const auto value = [](int k, int x, int y, int z) { return 1000 * k + 100 * x + 10 * y + z; };
  for (const Layout layout : {Layout::components_in_rows, Layout::separate_components}) {
    RowField<float> field(box, 2, layout);
    for_each_row_in_order(box, [&](int y, int z) {
      for (int k = 0; k < 2; ++k)
        for (int x = 0; x < 3; ++x) field.row(k, y, z)[x] = float(value(k, x, y, z));
    });
    fill_ghosts(field, rules, {.wall = kExchanged, .mirror = {}, .half_turn = {}});
    for_each_row_in_order(grown(box, 1), [&](int y, int z) {
      const bool is_behind_wall = y < 0 || y > 1;
      for (int k = 0; k < 2; ++k)
        for (int x = -1; x <= 3; ++x)
          EXPECT_EQ(field.row(k, y, z)[x], float(value(is_behind_wall ? 1 - k : k, periodic(x, 3),
                                                       std::clamp(y, 0, 1), periodic(z, 4))))
              << k << " " << x << " " << y << " " << z;
    });
  }
}

}  // namespace
}  // namespace capstan
