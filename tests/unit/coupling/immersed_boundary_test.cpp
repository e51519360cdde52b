#include "solver/coupling/immersed_boundary.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

const GridGeometry kGrid{.origin = {-1.9, -1.7, -1.8}, .dx = 0.2};

/// A sphere with a force at every vertex, and the forces on the cells.
class ImmersedBoundaryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(boundary_.place(positions_, 0));
    box_.reset(boundary_.box_lo(), boundary_.box_size());
  }

  Points random_points() {
    return Points::NullaryExpr(3, positions_.cols(), [this] { return number_(generator_); });
  }

  void fill_at_random(VectorBox& box) {
    for (int c = 0; c < 3; ++c)
      box.for_each_row([&](int y, int z) {
        for (int i = 0; i < box.size()[0]; ++i) box.row(c, y, z)[i] = number_(generator_);
      });
  }

  /// Sum over the cells of visit(cell centre, vector of the cell).
  template <class Visit>
  void for_each_cell(const VectorBox& box, const Visit& visit) {
    box.for_each_row([&](int y, int z) {
      for (int i = 0; i < box.size()[0]; ++i)
        visit(Vec3(kGrid.origin + kGrid.dx * Vec3(box.lo()[0] + i, y, z)),
              Vec3(box.row(0, y, z)[i], box.row(1, y, z)[i], box.row(2, y, z)[i]));
    });
  }

  std::mt19937 generator_{7};
  std::uniform_real_distribution<double> number_{-1, 1};
  Points positions_ = testing::bumped(make_icosphere(2).directions, 0.05);
  ImmersedBoundary boundary_{kGrid};
  VectorBox box_;
};

TEST_F(ImmersedBoundaryTest, SpreadAndInterpolateAreAdjoint) {
  const Points forces = random_points();
  VectorBox velocity = box_;
  fill_at_random(velocity);
  boundary_.spread(forces, 1, box_);
  Points interpolated(3, positions_.cols());
  boundary_.interpolate(velocity, 1, interpolated);
  double on_grid = 0;
  for (std::size_t i = 0; i < box_.values().size(); ++i) on_grid += box_.values()[i] * velocity.values()[i];
  EXPECT_NEAR(on_grid, forces.cwiseProduct(interpolated).sum(), 1e-12);
}

TEST_F(ImmersedBoundaryTest, GridCarriesTheForceOfTheMembrane) {
  const Points forces = random_points();
  boundary_.spread(forces, 3, box_);
  Vec3 total = Vec3::Zero();
  for_each_cell(box_, [&](const Vec3&, const Vec3& force) { total += force; });
  EXPECT_LT((total - 3 * testing::total_force(forces)).norm(), 1e-12);
}

// The cosine of eq. 35 does not have the first moment of a delta function exactly: a point force may move by
// up to 0.02 dx off its point, and over many vertices that averages out.
TEST_F(ImmersedBoundaryTest, GridCarriesTheTorqueOfTheMembraneToOnePerMilleOfTheForcesMoments) {
  const Points forces = random_points();
  boundary_.spread(forces, 1, box_);
  Vec3 torque = Vec3::Zero();
  for_each_cell(box_, [&](const Vec3& at, const Vec3& force) { torque += at.cross(force); });
  const double moments = forces.colwise().norm().sum();
  EXPECT_LT((torque - testing::total_torque(positions_, forces)).norm(), 1e-3 * moments);
}

TEST_F(ImmersedBoundaryTest, UniformVelocityIsInterpolatedExactly) {
  box_.reset(boundary_.box_lo(), boundary_.box_size(), 2);
  Points velocities(3, positions_.cols());
  boundary_.interpolate(box_, 0.5, velocities);
  EXPECT_LT((velocities.array() - 1).abs().maxCoeff(), 1e-14);
}

TEST_F(ImmersedBoundaryTest, MarginWidensTheBoxOnEverySide) {
  const auto lo = boundary_.box_lo(), size = boundary_.box_size();
  ASSERT_TRUE(boundary_.place(positions_, 2));
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(boundary_.box_lo()[c], lo[c] - 2);
    EXPECT_EQ(boundary_.box_size()[c], size[c] + 4);
  }
}

TEST_F(ImmersedBoundaryTest, LostPositionsAreRefused) {
  using limits = std::numeric_limits<double>;
  for (double lost : {limits::quiet_NaN(), limits::infinity(), -limits::infinity(), 1e12, -1e12})
    for (int c = 0; c < 3; ++c) {
      Points positions = positions_;
      positions(c, 40) = lost;
      EXPECT_FALSE(boundary_.place(positions, 0)) << lost << " in component " << c;
    }
}

}  // namespace
}  // namespace capstan
