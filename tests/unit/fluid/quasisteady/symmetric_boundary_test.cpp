// Spreading and interpolating on a quarter of the grid give the same as on the whole grid.
#include "solver/fluid/quasisteady/symmetric_boundary.hpp"

#include <gtest/gtest.h>

#include "solver/grid/for_each_row.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

constexpr double kSpacing = 0.2;
const GridGeometry kSymmetricGrid{Vec3::Constant(kSpacing / 2), kSpacing};

struct SymmetricCapsule {
  Icosphere sphere = make_icosphere(3);
  Orbits orbits = Orbits::of(sphere.directions);
  Points positions, normals, vectors;

  /// A bumped sphere, and vectors at its vertices, both with the symmetry.
  SymmetricCapsule()
      : positions(orbits.extend(orbits.restrict(testing::bumped(sphere.directions, 0.02)))),
        normals(orbits.extend(orbits.restrict(vertex_normals(positions, sphere.mesh.faces)))),
        vectors(orbits.extend(orbits.restrict(testing::bumped(Points::Zero(3, positions.cols()), 1)))) {}
};

TEST(SymmetricBoundary, SpreadsInItsQuarterWhatTheWholeMembraneSpreadsThere) {
  const SymmetricCapsule capsule;
  SymmetricBoundary quarter(kSymmetricGrid, capsule.orbits),
      whole(kSymmetricGrid, Orbits::without_symmetry(int(capsule.positions.cols())));
  ASSERT_TRUE(quarter.place(capsule.positions, capsule.normals) &&
              whole.place(capsule.positions, capsule.normals));
  ASSERT_TRUE(quarter.has_symmetry() && !whole.has_symmetry());
  VectorField part, all;
  quarter.spread(capsule.vectors, capsule.vectors, 1, part);
  whole.spread(capsule.vectors, capsule.vectors, 1, all);
  double largest = 0;
  for_each_row_in_order(part.box(), [&](int y, int z) {
    for (int c = 0; c < 3; ++c)
      for (int i = 0, x = part.box().lo[0]; i < part.box().size(0); ++i, ++x) {
        const int j = x - all.box().lo[0];
        const bool is_in_both = all.box().has_row(y, z) && j >= 0 && j < all.box().size(0);
        const double expected = is_in_both ? all.row(c, y, z)[j] : 0;
        largest = std::max(largest, std::abs(part.row(c, y, z)[i] - expected));
      }
  });
  EXPECT_LT(largest, 1e-13);
}

/// The capsule's vectors spread onto the grid, and the velocities interpolated from there.
struct ThereAndBack {
  VectorField forces;
  Points velocities;
};
ThereAndBack there_and_back(const SymmetricCapsule& capsule) {
  SymmetricBoundary boundary(kSymmetricGrid, capsule.orbits);
  EXPECT_TRUE(boundary.place(capsule.positions, capsule.normals));
  ThereAndBack result;
  boundary.spread(capsule.vectors, Points(3, 0), 1, result.forces);
  boundary.interpolate(result.forces, result.velocities);
  return result;
}

TEST(SymmetricBoundary, SpreadingAndInterpolatingAreAdjoint) {
  const SymmetricCapsule capsule;
  const auto [forces, velocities] = there_and_back(capsule);
  double on_grid = 0;
  for (double number : forces.values()) on_grid += number * number;
  EXPECT_NEAR(4 * on_grid, capsule.vectors.cwiseProduct(velocities).sum(), 1e-10);
}

TEST(SymmetricBoundary, VelocitiesHaveTheSymmetryBitForBit) {
  const SymmetricCapsule capsule;
  const auto [forces, velocities] = there_and_back(capsule);
  EXPECT_EQ(velocities, capsule.orbits.extend(capsule.orbits.restrict(velocities)));
}

}  // namespace
}  // namespace capstan
