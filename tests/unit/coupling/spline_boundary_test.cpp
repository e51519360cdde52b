// The spline coupling: exact for linear flows, and adjoint.
#include "solver/coupling/spline_boundary.hpp"

#include <gtest/gtest.h>

#include <random>

#include "solver/grid/for_each_row.hpp"
#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

TEST(SplineKernel, HasTheMomentsOfAPointButForTheSecondWhichIsOneThird) {
  for (int n = -30; n <= 30; ++n) {
    const double position = n / 11.0;
    const SplineStencil stencil = spline_stencil(position);
    double sum = 0, first = 0, second = 0, slopes = 0, slope_moment = 0;
    for (int i = 0; i < 4; ++i) {
      const double x = stencil.first + i - position;
      sum += stencil.weight[i], first += x * stencil.weight[i], second += x * x * stencil.weight[i];
      slopes += stencil.slope[i], slope_moment += x * stencil.slope[i];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_NEAR(first, 0, 1e-14);
    EXPECT_NEAR(second, 1. / 3, 1e-14);
    EXPECT_NEAR(slopes, 0, 1e-14);
    EXPECT_NEAR(slope_moment, -1, 1e-14);
  }
}

TEST(SplineKernel, SlopesAreTheDerivativesOfTheWeights) {
  constexpr double kStep = 1e-5;
  for (double position : {0.1, 0.37, 0.5, 0.92}) {
    const SplineStencil left = spline_stencil(position - kStep), right = spline_stencil(position + kStep);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(spline_stencil(position).slope[i], -(right.weight[i] - left.weight[i]) / (2 * kStep), 1e-9);
  }
}

const GridGeometry kSplineGrid{.origin = {-1.9, -1.7, -1.8}, .dx = 0.2};

class SplineBoundaryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(boundary_.place(positions_));
    field_.reset(boundary_.box());
  }
  Points random_points() {
    return Points::NullaryExpr(3, positions_.cols(), [this] { return number_(generator_); });
  }
  /// field(x) = value(x).
  template <class Value>
  void fill(VectorField& field, Value value) {
    for_each_row_in_order(field.box(), [&](int y, int z) {
      for (int i = 0; i < field.box().size(0); ++i) {
        const Vec3 vector =
            value(Vec3(kSplineGrid.origin + kSplineGrid.dx * Vec3(field.box().lo[0] + i, y, z)));
        for (int c = 0; c < 3; ++c) field.row(c, y, z)[i] = vector[c];
      }
    });
  }
  std::mt19937 generator_{7};
  std::uniform_real_distribution<double> number_{-1, 1};
  Points positions_ = testing::bumped(make_icosphere(2).directions, 0.05);
  SplineBoundary boundary_{kSplineGrid};
  VectorField field_;
};

TEST_F(SplineBoundaryTest, LinearFlowIsReadExactlyWithItsGradient) {
  Eigen::Matrix3d gradient;
  gradient << 1, 2, 3, -4, 5, 6, 7, -8, 9;
  const Vec3 at_origin(1, -2, 0.5);
  fill(field_, [&](const Vec3& x) { return Vec3(at_origin + gradient * x); });
  Points velocities;
  Tensors gradients;
  boundary_.interpolate(field_, velocities, gradients);
  const Points exact = (gradient * positions_).colwise() + at_origin;
  EXPECT_LT((velocities - exact).cwiseAbs().maxCoeff(), 1e-12);
  for (Eigen::Index k = 0; k < positions_.cols(); ++k)
    EXPECT_LT((gradients.col(k).reshaped(3, 3).transpose() - gradient).norm(), 1e-11);
  Points alone;
  boundary_.interpolate(field_, alone);
  EXPECT_LT((alone - velocities).cwiseAbs().maxCoeff(), 1e-13);
}

TEST_F(SplineBoundaryTest, SpreadAndInterpolateAreAdjointForForcesAndDipoles) {
  const Points forces = random_points();
  const Tensors dipoles = Tensors::NullaryExpr(9, forces.cols(), [this] { return number_(generator_); });
  VectorField velocity = field_;
  fill(velocity, [this](const Vec3&) { return Vec3(number_(generator_), number_(generator_), 1); });
  boundary_.spread(forces, dipoles, 1, field_);
  Points velocities;
  Tensors gradients;
  boundary_.interpolate(velocity, velocities, gradients);
  double on_grid = 0;
  for (std::size_t i = 0; i < field_.values().size(); ++i)
    on_grid += field_.values()[i] * velocity.values()[i];
  EXPECT_NEAR(on_grid, forces.cwiseProduct(velocities).sum() + dipoles.cwiseProduct(gradients).sum(), 1e-10);
}

TEST_F(SplineBoundaryTest, GridCarriesForceAndTorqueAndSymmetricDipolesHaveNeither) {
  const Points forces = random_points(), along = random_points(), across = random_points();
  Tensors dipoles(9, forces.cols());
  for (Eigen::Index k = 0; k < forces.cols(); ++k) {
    const Eigen::Matrix3d T = along.col(k) * across.col(k).transpose();
    dipoles.col(k) = Eigen::Matrix3d(T + T.transpose()).reshaped();
  }
  boundary_.spread(forces, dipoles, 1, field_);
  Vec3 total = Vec3::Zero(), torque = Vec3::Zero();
  for_each_row_in_order(field_.box(), [&](int y, int z) {
    for (int i = 0; i < field_.box().size(0); ++i) {
      const Vec3 force(field_.row(0, y, z)[i], field_.row(1, y, z)[i], field_.row(2, y, z)[i]);
      total += force;
      torque += Vec3(kSplineGrid.origin + kSplineGrid.dx * Vec3(field_.box().lo[0] + i, y, z)).cross(force);
    }
  });
  EXPECT_LT((total - testing::total_force(forces)).norm(), 1e-11);
  EXPECT_LT((torque - testing::total_torque(positions_, forces)).norm(), 1e-11);
}

TEST_F(SplineBoundaryTest, LostPositionsAreRefused) {
  positions_(0, 3) = std::nan("");
  EXPECT_FALSE(boundary_.place(positions_));
}

}  // namespace
}  // namespace capstan
