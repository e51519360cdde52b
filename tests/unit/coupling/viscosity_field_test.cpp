#include "solver/coupling/viscosity_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/grid/for_each_row.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/shapes.hpp"
#include "tests/support/test_names.hpp"

namespace capstan {
namespace {

/// The viscosity around a membrane, in a cube of edge 3.2 around the origin.
class Field {
 public:
  Field(const Points& positions, const TriangleMesh& mesh, double dx, double inner)
      : grid_{.origin = Vec3::Constant(0.5 * dx - 1.6), .dx = dx} {
    const int n = int(std::lround(3.2 / dx));
    viscosity_.reset(box_from_zero({n, n, n}));
    ViscosityField(grid_, mesh, Orbits::without_symmetry(mesh.vertex_count()))
        .update(positions, smoothed_jump(inner, kAmbient), viscosity_);
  }

  /// Calls visit(cell centre, viscosity) for all cells.
  template <class Visit>
  void for_each_cell(const Visit& visit) const {
    for_each_row_in_order(viscosity_.box(), [&](int y, int z) {
      for (int x = 0; x < viscosity_.box().size(0); ++x)
        visit(Vec3(grid_.origin + grid_.dx * Vec3(x, y, z)), viscosity_.row(0, y, z)[x]);
    });
  }

  static constexpr double kAmbient = 0.5;

 private:
  GridGeometry grid_;
  ScalarField viscosity_;
};

/// The volume filled with the inner viscosity: each cell counts with its share of the jump.
double filled_volume(const Field& field, double dx, double inner) {
  double cells = 0;
  field.for_each_cell(
      [&](const Vec3&, double nu) { cells += (nu - Field::kAmbient) / (inner - Field::kAmbient); });
  return cells * dx * dx * dx;
}

class BothSidesOfOne : public ::testing::TestWithParam<double> {
 protected:
  double inner() const { return GetParam() * Field::kAmbient; }
};

TEST_P(BothSidesOfOne, SphereHasTheExactSmoothedJump) {
  const Icosphere sphere = make_icosphere(4);
  const double dx = 0.1, jump = inner() - Field::kAmbient;
  double worst = 0;
  Field(sphere.directions, sphere.mesh, dx, inner()).for_each_cell([&](const Vec3& at, double nu) {
    const double exact = inner() - jump * smoothed_heaviside((at.norm() - 1) / dx, kPaperHalfWidth);
    worst = std::max(worst, std::abs((nu - exact) / jump));
  });
  EXPECT_LT(worst, 0.005);
}

TEST_P(BothSidesOfOne, OnlyTheBiconcaveCapsuleIsFilled) {
  const Icosphere sphere = make_icosphere(4);
  Case c;
  c.shape = Shape::biconcave;
  const Points positions = initial_positions(c, sphere);
  const Field field(positions, sphere.mesh, 0.1, inner());
  EXPECT_NEAR(filled_volume(field, 0.1, inner()), 4 * std::numbers::pi / 3, 0.03 * 4 * std::numbers::pi / 3);
  field.for_each_cell([&](const Vec3& at, double nu) {
    EXPECT_GE(nu, std::min(inner(), Field::kAmbient) - 1e-12);
    EXPECT_LE(nu, std::max(inner(), Field::kAmbient) + 1e-12);
    if (at.norm() > 1.6) {
      EXPECT_EQ(nu, Field::kAmbient);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(ViscosityField, BothSidesOfOne, ::testing::Values(0.1, 10.0),
                         capstan::testing::number_names("V"));

// Cells near the circle along which the biconcave shape is thickest.
TEST(ViscosityField, RimOfABiconcaveShapeIsInsideAllAround) {
  const Icosphere sphere = make_icosphere(4);
  Case c;
  c.shape = Shape::biconcave;
  const Points positions = initial_positions(c, sphere);
  const Vec3 axis = Vec3(-1, 1, 0).normalized();
  const Field field(positions, sphere.mesh, 0.1, 5);
  int deep = 0;
  field.for_each_cell([&](const Vec3& at, double nu) {
    const double along = at.dot(axis), across = (at - along * axis).norm();
    if (std::hypot(along, across - 0.95) > 0.2) return;
    ++deep;
    EXPECT_NEAR(nu, 5, 0.05) << at.transpose();
  });
  EXPECT_GT(deep, 500);
}

// Smoothing with a kernel of variance s^2 increases the volume of the unit sphere by the factor 1 + 3 s^2.
// The kernel of eq. 41 has s^2 = 4 dx^2 (1/3 - 2/pi^2).
TEST(ViscosityField, SphereIsOverfilledByTheEffectOfSmoothingOnly) {
  const Icosphere sphere = make_icosphere(4);
  const double exact = volume(sphere.directions, sphere.mesh.faces);
  for (double dx : {0.2, 0.1, 0.05}) {
    const double variance = 4 * dx * dx * (1.0 / 3 - 2 / (std::numbers::pi * std::numbers::pi));
    const Field field(sphere.directions, sphere.mesh, dx, 5);
    EXPECT_NEAR(filled_volume(field, dx, 5) / exact, 1 + 3 * variance, 0.003) << dx;
  }
}

TEST(ViscosityField, HasTheProfileOfDistanceAndCurvatureOfASphere) {
  const Icosphere sphere = make_icosphere(4);
  constexpr double kDx = 0.1;
  const GridGeometry grid{.origin = Vec3::Constant(0.5 * kDx - 1.6), .dx = kDx};
  ScalarField viscosity;
  viscosity.reset(box_from_zero({32, 32, 32}));
  const ViscosityProfile profile = [](double z, double curvature) {
    return 5 + 20 * curvature * std::tanh(z) * (std::abs(z) < 2);
  };
  ViscosityField(grid, sphere.mesh, Orbits::without_symmetry(sphere.mesh.vertex_count()))
      .update(sphere.directions, profile, viscosity);
  for_each_row_in_order(viscosity.box(), [&](int y, int z) {
    for (int x = 0; x < 32; ++x) {
      const double distance = ((grid.origin + kDx * Vec3(x, y, z)).norm() - 1) / kDx;
      if (std::abs(distance) < 1.9) {
        EXPECT_NEAR(viscosity.row(0, y, z)[x], profile(distance, kDx), 0.05);
      }
      if (std::abs(distance) > 2.5) {
        EXPECT_EQ(viscosity.row(0, y, z)[x], 5);
      }
    }
  });
}

TEST(SmoothedHeaviside, RisesFromZeroToOneOverTwoCellsOnEitherSide) {
  EXPECT_NEAR(smoothed_heaviside(-2, kPaperHalfWidth), 0, 1e-15);
  EXPECT_NEAR(smoothed_heaviside(-5, kPaperHalfWidth), 0, 1e-15);
  EXPECT_EQ(smoothed_heaviside(0, kPaperHalfWidth), 0.5);
  EXPECT_NEAR(smoothed_heaviside(2, kPaperHalfWidth), 1, 1e-15);
  EXPECT_NEAR(smoothed_heaviside(1, kPaperHalfWidth) + smoothed_heaviside(-1, kPaperHalfWidth), 1, 1e-15);
  EXPECT_NEAR(smoothed_heaviside(1, kPaperHalfWidth), 0.75 + 0.5 / std::numbers::pi, 1e-15);
}

}  // namespace
}  // namespace capstan
