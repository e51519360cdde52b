#include "solver/coupling/immersed_boundary.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "solver/grid/for_each_row.hpp"
#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

const GridGeometry kGrid{.origin = {-1.9, -1.7, -1.8}, .dx = 0.2};

/// A bumped sphere, and a field over the cells that it touches.
class ImmersedBoundaryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(boundary_.place(positions_, 0));
    field_.reset(boundary_.box());
  }

  Points random_points() {
    return Points::NullaryExpr(3, positions_.cols(), [this] { return number_(generator_); });
  }

  void fill_at_random(VectorField& field) {
    for (int c = 0; c < 3; ++c)
      for_each_row_in_order(field.box(), [&](int y, int z) {
        for (int i = 0; i < field.box().size(0); ++i) field.row(c, y, z)[i] = number_(generator_);
      });
  }

  /// Calls visit(cell centre, vector of the cell) for all cells.
  template <class Visit>
  void for_each_cell(const VectorField& field, const Visit& visit) {
    for_each_row_in_order(field.box(), [&](int y, int z) {
      for (int i = 0; i < field.box().size(0); ++i)
        visit(Vec3(kGrid.origin + kGrid.dx * Vec3(field.box().lo[0] + i, y, z)),
              Vec3(field.row(0, y, z)[i], field.row(1, y, z)[i], field.row(2, y, z)[i]));
    });
  }

  std::mt19937 generator_{7};
  std::uniform_real_distribution<double> number_{-1, 1};
  Points positions_ = testing::bumped(make_icosphere(2).directions, 0.05);
  ImmersedBoundary boundary_{kGrid};
  VectorField field_;
};

TEST_F(ImmersedBoundaryTest, SpreadAndInterpolateAreAdjoint) {
  const Points forces = random_points();
  VectorField velocity = field_;
  fill_at_random(velocity);
  boundary_.spread(forces, 1, field_);
  Points interpolated(3, positions_.cols());
  boundary_.interpolate(velocity, 1, interpolated);
  double on_grid = 0;
  for (std::size_t i = 0; i < field_.values().size(); ++i)
    on_grid += field_.values()[i] * velocity.values()[i];
  EXPECT_NEAR(on_grid, forces.cwiseProduct(interpolated).sum(), 1e-12);
}

TEST_F(ImmersedBoundaryTest, GridCarriesTheForceOfTheMembrane) {
  const Points forces = random_points();
  boundary_.spread(forces, 3, field_);
  Vec3 total = Vec3::Zero();
  for_each_cell(field_, [&](const Vec3&, const Vec3& force) { total += force; });
  EXPECT_LT((total - 3 * testing::total_force(forces)).norm(), 1e-12);
}

// The first moment of the discrete delta function of eq. 35 is not exactly zero: the force of one vertex may
// be displaced by up to 0.02 dx. Over many vertices the errors nearly cancel.
TEST_F(ImmersedBoundaryTest, GridCarriesTheTorqueOfTheMembraneToOnePerMilleOfTheForcesMoments) {
  const Points forces = random_points();
  boundary_.spread(forces, 1, field_);
  Vec3 torque = Vec3::Zero();
  for_each_cell(field_, [&](const Vec3& at, const Vec3& force) { torque += at.cross(force); });
  const double moments = forces.colwise().norm().sum();
  EXPECT_LT((torque - testing::total_torque(positions_, forces)).norm(), 1e-3 * moments);
}

TEST_F(ImmersedBoundaryTest, UniformVelocityIsInterpolatedExactly) {
  field_.reset(boundary_.box(), 2);
  Points velocities(3, positions_.cols());
  boundary_.interpolate(field_, 0.5, velocities);
  EXPECT_LT((velocities.array() - 1).abs().maxCoeff(), 1e-14);
}

TEST_F(ImmersedBoundaryTest, MarginWidensTheBoxOnEverySide) {
  const IndexBox without = boundary_.box();
  ASSERT_TRUE(boundary_.place(positions_, 2));
  EXPECT_EQ(boundary_.box(), grown(without, 2));
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
