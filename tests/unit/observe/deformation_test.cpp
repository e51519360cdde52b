#include "solver/observe/deformation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/mesh/icosphere.hpp"
#include "solver/mesh/shapes.hpp"

namespace capstan {
namespace {

using std::numbers::pi;

/// An ellipsoid whose longest axis makes the angle `theta` with x.
Points ellipsoid(const Icosphere& sphere, double a, double b, double theta) {
  return Eigen::AngleAxisd(theta, Vec3::UnitZ()).toRotationMatrix() * Vec3(a, b, 1).asDiagonal() *
         sphere.directions;
}

TEST(Deformation, OfAnEllipsoidIsTheTaylorDeformationOfItsAxes) {
  const Icosphere sphere = make_icosphere(2);
  const Points x = ellipsoid(sphere, 1.5, 0.8, 0.3);
  const auto [D_xy, theta] = deformation(inertia_ellipse(x, sphere.mesh.faces));
  EXPECT_NEAR(D_xy, (1.5 - 0.8) / (1.5 + 0.8), 1e-13);  // an affine image of the polyhedron of a sphere
  EXPECT_NEAR(theta, 0.3, 1e-13);
}

TEST(Deformation, HalfAxesConvergeToThoseOfTheEllipsoid) {
  const Icosphere sphere = make_icosphere(5);
  const InertiaEllipse ellipse = inertia_ellipse(ellipsoid(sphere, 1.5, 0.8, 0.3), sphere.mesh.faces);
  EXPECT_NEAR(ellipse.major, 1.5, 1e-3);
  EXPECT_NEAR(ellipse.minor, 0.8, 1e-3);
}

TEST(Deformation, AngleIsInTheHalfOpenIntervalUpToHalfPi) {
  const Icosphere sphere = make_icosphere(1);
  EXPECT_NEAR(inertia_ellipse(ellipsoid(sphere, 2, 1, 0.6 * pi), sphere.mesh.faces).theta, -0.4 * pi, 1e-13);
  const Points upright = Vec3(1, 2, 1).asDiagonal() * sphere.directions;
  EXPECT_DOUBLE_EQ(std::abs(inertia_ellipse(upright, sphere.mesh.faces).theta), pi / 2);
}

TEST(Deformation, DoesNotDependOnThePositionOfTheCapsule) {
  const Icosphere sphere = make_icosphere(2);
  const Points here = ellipsoid(sphere, 1.5, 0.8, 0.3), there = here.colwise() + Vec3(4, -2, 1);
  const InertiaEllipse a = inertia_ellipse(here, sphere.mesh.faces),
                       b = inertia_ellipse(there, sphere.mesh.faces);
  EXPECT_NEAR(a.theta, b.theta, 1e-12);
  EXPECT_NEAR(a.major, b.major, 1e-12);
}

TEST(Deformation, OfTheInitialBiconcaveShapeIsTheReferenceValue) {
  Case c;
  c.shape = Shape::biconcave;
  const Icosphere sphere = make_icosphere(4);
  const auto [D_xy, theta] = deformation(inertia_ellipse(initial_positions(c, sphere), sphere.mesh.faces));
  EXPECT_NEAR(theta, pi / 4, 1e-13);
  EXPECT_GT(D_xy, 0.45);
  EXPECT_LT(D_xy, 0.6);
}

}  // namespace
}  // namespace capstan
