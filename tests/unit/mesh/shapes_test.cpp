#include "solver/mesh/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "solver/mesh/geometry.hpp"

namespace capstan {
namespace {

Case of_shape(Shape shape, double aspect = 1) {
  Case c;
  c.shape = shape;
  c.aspect = aspect;
  return c;
}

const Case kShapes[] = {of_shape(Shape::sphere), of_shape(Shape::oblate, 0.5), of_shape(Shape::prolate, 2),
                        of_shape(Shape::biconcave)};

/// Half the extent of the shape along a unit direction.
double half_extent(const Points& positions, const Vec3& direction) {
  const auto heights = direction.transpose() * positions;
  return (heights.maxCoeff() - heights.minCoeff()) / 2;
}

const Vec3 kDiagonal = Vec3(1, 1, 0).normalized();
const Vec3 kAcross = Vec3(-1, 1, 0).normalized();

TEST(InitialShape, TriangulatedSurfaceEnclosesTheVolumeOfTheUnitSphere) {
  const Icosphere sphere = make_icosphere(3);
  for (const Case& c : kShapes)
    EXPECT_NEAR(volume(initial_positions(c, sphere), sphere.mesh.faces), 4 * std::numbers::pi / 3, 1e-13);
}

TEST(InitialShape, MajorAxisLiesOnTheDiagonalOfTheShearPlane) {
  const Icosphere sphere = make_icosphere(3);
  for (const Case& c : kShapes) {
    const Eigen::Matrix3d m = second_moments(initial_positions(c, sphere), sphere.mesh.faces);
    if (c.shape == Shape::sphere) continue;
    EXPECT_NEAR(m(0, 0), m(1, 1), 1e-13);
    EXPECT_GT(m(0, 1), 0);
  }
}

TEST(InitialShape, SpheroidHasTheAspectAskedFor) {
  const Icosphere sphere = make_icosphere(4);
  const Points oblate = initial_positions(of_shape(Shape::oblate, 0.5), sphere);
  EXPECT_NEAR(half_extent(oblate, kAcross) / half_extent(oblate, Vec3::UnitZ()), 0.5, 1e-3);
  const Points prolate = initial_positions(of_shape(Shape::prolate, 2), sphere);
  EXPECT_NEAR(half_extent(prolate, kDiagonal) / half_extent(prolate, Vec3::UnitZ()), 2, 4e-3);
}

TEST(InitialShape, BiconcaveHasItsDimplesAndRimWhereFungMeasuredThem) {
  const Points x = biconcave(make_icosphere(5).directions);
  EXPECT_NEAR(x.row(0).maxCoeff(), 1.3858, 1e-12);
  double thinnest = 10, thickest = 0;
  for (const auto& p : x.colwise()) {
    thickest = std::max(thickest, p.y());
    if (std::hypot(p.x(), p.z()) < 0.05 && p.y() > 0) thinnest = std::min(thinnest, p.y());
  }
  EXPECT_NEAR(thinnest, 1.3858 / 2 * 0.207, 2e-3);
  EXPECT_NEAR(thickest, 0.456, 2e-3);
}

TEST(InitialShape, BiconcaveVolumeOfEquation46IsThatOfTheUnitSphere) {
  const Icosphere sphere = make_icosphere(5);
  EXPECT_NEAR(volume(biconcave(sphere.directions), sphere.mesh.faces) / (4 * std::numbers::pi / 3), 1, 2e-3);
}

TEST(InitialShape, TrianglesOfTheBiconcaveStayWellShaped) {
  const Icosphere sphere = make_icosphere(4);
  const Points x = biconcave(sphere.directions);
  for (const auto& f : sphere.mesh.faces.colwise()) {
    const Vec3 a = x.col(f[1]) - x.col(f[0]), b = x.col(f[2]) - x.col(f[1]), c = x.col(f[0]) - x.col(f[2]);
    const double quality =
        2 * std::sqrt(3) * a.cross(b).norm() / (a.squaredNorm() + b.squaredNorm() + c.squaredNorm());
    EXPECT_GT(quality, 0.6);  // 1 for an equilateral triangle, 0 for a collapsed one
  }
}

TEST(InitialShape, SymmetriesOfTheShearPlaneSurviveWithoutRounding) {
  const Icosphere sphere = make_icosphere(3);
  for (const Case& c : kShapes) {
    const Points x = initial_positions(c, sphere);
    const auto contains = [at = [&] {
      std::set<std::array<double, 3>> points;
      for (const auto& p : x.colwise()) points.insert({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0});
      return points;
    }()](double a, double b, double d) {
      return at.contains({a + 0.0, b + 0.0, d + 0.0});
    };
    for (const auto& p : x.colwise()) {
      EXPECT_TRUE(contains(p[0], p[1], -p[2])) << to_string(c.shape);
      EXPECT_TRUE(contains(-p[0], -p[1], p[2])) << to_string(c.shape);
    }
  }
}

}  // namespace
}  // namespace capstan
