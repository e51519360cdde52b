#include "solver/mesh/curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"
#include "solver/mesh/quadric_fit.hpp"
#include "solver/mesh/shapes.hpp"

namespace capstan {
namespace {

using std::numbers::pi;

TEST(Curvature, FittedGaussianCurvatureObeysGaussBonnet) {
  const Icosphere sphere = make_icosphere(5);
  const Points x = biconcave(sphere.directions);
  const double total = fit_quadrics(sphere.mesh, x).gaussian.dot(mixed_areas(x, sphere.mesh.faces));
  EXPECT_NEAR(total / (4 * pi), 1, 0.01);
}

TEST(Curvature, MixedAreasSumUpToTheArea) {
  const Icosphere sphere = make_icosphere(3);
  const Points x = spheroid(sphere.directions, 0.2);  // flat enough for obtuse triangles
  EXPECT_NEAR(mixed_areas(x, sphere.mesh.faces).sum(), area(x, sphere.mesh.faces), 1e-12);
  EXPECT_GT(mixed_areas(x, sphere.mesh.faces).minCoeff(), 0);
}

TEST(Curvature, OfASphereIsOneOverItsRadiusWithAPositiveSign) {
  const Icosphere sphere = make_icosphere(4);
  const Points x = 2 * sphere.directions;
  EXPECT_LT((mean_curvature(sphere.mesh.faces, x, vertex_normals(x, sphere.mesh.faces)).array() - 0.5)
                .abs()
                .maxCoeff(),
            0.01);
  EXPECT_LT((fit_quadrics(sphere.mesh, x).mean.array() - 0.5).abs().maxCoeff(), 0.01);
  EXPECT_LT((fit_quadrics(sphere.mesh, x).gaussian.array() - 0.25).abs().maxCoeff(), 0.01);
}

/// H of the spheroid x = (cos phi sin theta, b cos theta, sin phi sin theta) at height y.
double spheroid_mean_curvature(double b, double y) {
  const double cos2 = y * y / (b * b), g = b * b + (1 - b * b) * cos2;  // squared speed along a meridian
  return (b / std::pow(g, 1.5) + b / std::sqrt(g)) / 2;
}

TEST(Curvature, FitConvergesToTheExactOneOfASpheroid) {
  const double b = 0.5;
  double previous = 1;
  for (int n : {3, 4, 5}) {
    const Icosphere sphere = make_icosphere(n);
    const Points x = spheroid(sphere.directions, b);
    const Scalars fitted = fit_quadrics(sphere.mesh, x).mean;
    double error = 0;
    for (int i = 0; i < x.cols(); ++i)
      error = std::max(error, std::abs(fitted[i] - spheroid_mean_curvature(b, x(1, i))));
    EXPECT_LT(error, 0.6 * previous);
    previous = error;
  }
  EXPECT_LT(previous, 0.02);
}

TEST(Curvature, FittedNormalsOfASpheroidAreBetterThanAreaWeightedOnes) {
  const double b = 0.5;
  const Icosphere sphere = make_icosphere(4);
  const Points x = spheroid(sphere.directions, b);
  const Points exact = (Vec3(1, 1 / (b * b), 1).asDiagonal() * x).colwise().normalized();
  const double fitted = (fit_quadrics(sphere.mesh, x).normals - exact).norm();
  EXPECT_LT(fitted, (vertex_normals(x, sphere.mesh.faces) - exact).norm());
}

TEST(LaplaceBeltrami, HasTheSphericalHarmonicsOfDegreeOneAndTwoAsEigenfunctions) {
  const Icosphere sphere = make_icosphere(5);
  const Points& x = sphere.directions;
  const Scalars first = x.row(2);
  const Scalars second = x.row(0).cwiseProduct(x.row(1));
  EXPECT_LT((laplace_beltrami(sphere.mesh.faces, x, first) + 2 * first).cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT((laplace_beltrami(sphere.mesh.faces, x, second) + 6 * second).cwiseAbs().maxCoeff(), 0.1);
}

TEST(LaplaceBeltrami, OfAConstantIsZero) {
  const Icosphere sphere = make_icosphere(2);
  const Scalars one = Scalars::Ones(sphere.mesh.vertex_count());
  EXPECT_EQ(laplace_beltrami(sphere.mesh.faces, sphere.directions, one).cwiseAbs().maxCoeff(), 0);
}

}  // namespace
}  // namespace capstan
