// A quarter of the grid knows all: what is spread there and interpolated from there is what the whole would
// give.
#include "solver/fluid/quasisteady/symmetric_boundary.hpp"

#include <gtest/gtest.h>

#include "solver/grid/ghosts.hpp"
#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

constexpr double kDx = 0.2;
const GridGeometry kGrid{Vec3::Constant(kDx / 2), kDx};

struct Capsule {
  Icosphere sphere = make_icosphere(3);
  Orbits orbits = Orbits::of(sphere.directions);
  Points positions, vectors;

  /// Bumps, and any vectors, that have the symmetry.
  Capsule()
      : positions(orbits.extend(orbits.restrict(testing::bumped(sphere.directions, 0.02)))),
        vectors(orbits.extend(orbits.restrict(testing::bumped(Points::Zero(3, positions.cols()), 1)))) {}
};

TEST(SymmetricBoundary, SpreadsInItsQuarterWhatTheWholeMembraneSpreadsThere) {
  const Capsule capsule;
  SymmetricBoundary quarter(kGrid, capsule.orbits),
      whole(kGrid, Orbits::without_symmetry(int(capsule.positions.cols())));
  ASSERT_TRUE(quarter.place(capsule.positions) && whole.place(capsule.positions));
  ASSERT_TRUE(quarter.has_symmetry() && !whole.has_symmetry());
  VectorBox part, all;
  quarter.spread(capsule.vectors, 1, part);
  whole.spread(capsule.vectors, 1, all);
  double largest = 0;
  part.for_each_row([&](int y, int z) {
    for (int c = 0; c < 3; ++c)
      for (int i = 0, x = part.lo()[0]; i < part.size()[0]; ++i, ++x) {
        const int j = x - all.lo()[0];
        const double expected = all.has_row(y, z) && j >= 0 && j < all.size()[0] ? all.row(c, y, z)[j] : 0;
        largest = std::max(largest, std::abs(part.row(c, y, z)[i] - expected));
      }
  });
  EXPECT_LT(largest, 1e-13);
}

/// The capsule's vectors spread onto the grid, and what is interpolated from there.
struct ThereAndBack {
  VectorBox forces;
  Points velocities;
};
ThereAndBack there_and_back(const Capsule& capsule) {
  SymmetricBoundary boundary(kGrid, capsule.orbits);
  EXPECT_TRUE(boundary.place(capsule.positions));
  ThereAndBack result;
  boundary.spread(capsule.vectors, 1, result.forces);
  boundary.interpolate(result.forces, result.velocities);
  return result;
}

TEST(SymmetricBoundary, SpreadingAndInterpolatingAreAdjoint) {
  const Capsule capsule;
  const auto [forces, velocities] = there_and_back(capsule);
  double on_grid = 0;
  for (double number : forces.values()) on_grid += number * number;
  EXPECT_NEAR(4 * on_grid, capsule.vectors.cwiseProduct(velocities).sum(), 1e-10);
}

TEST(SymmetricBoundary, VelocitiesHaveTheSymmetryToTheLastBit) {
  const Capsule capsule;
  const auto [forces, velocities] = there_and_back(capsule);
  EXPECT_EQ(velocities, capsule.orbits.extend(capsule.orbits.restrict(velocities)));
}

/// A field with all symmetries, sampled around the quarter of a small box, ghosts included.
TEST(Ghosts, OfSymmetryPlanesAreTheImagesOfTheCells) {
  const IndexBox box{{-4, 0, 0}, {4, 3, 3}};
  const SideRules rules{{{{SideRule::periodic, SideRule::periodic},
                          {SideRule::half_turn, SideRule::interpolated},
                          {SideRule::mirror, SideRule::interpolated}}}};
  // rho, g of a flow that the half-turn about z and the mirror of z leave unchanged
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
  fill_ghosts(moments, rules, kMomentParity);
  const IndexBox with_low_sides{{-4, -1, -1}, {4, 3, 3}};
  visit(with_low_sides, [](double number, double value) { EXPECT_DOUBLE_EQ(number, value); });
}

}  // namespace
}  // namespace capstan
