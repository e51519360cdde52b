#include "solver/mesh/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/mesh/icosphere.hpp"

namespace capstan {
namespace {

using std::numbers::pi;

/// An ellipsoid with semi-axes a, b, c, centred off the origin.
const Vec3 kSemiAxes(1.3, 0.7, 0.9);
const Vec3 kCentre(0.4, -2, 1);

Points ellipsoid(const Icosphere& sphere) {
  return (kSemiAxes.asDiagonal() * sphere.directions).colwise() + kCentre;
}

TEST(Geometry, VolumeByHeightsAboveAPlaneEqualsVolumeByTetrahedra) {
  const Icosphere sphere = make_icosphere(2);
  const Points x = ellipsoid(sphere);
  const Points area_vectors = face_area_vectors(x, sphere.mesh.faces);
  double by_heights = 0;  // int z n_z dA
  for (Eigen::Index f = 0; f < sphere.mesh.faces.cols(); ++f) {
    const auto corners = sphere.mesh.faces.col(f);
    by_heights += area_vectors(2, f) * (x(2, corners[0]) + x(2, corners[1]) + x(2, corners[2])) / 3;
  }
  EXPECT_NEAR(by_heights, volume(x, sphere.mesh.faces), 1e-13);
}

TEST(Geometry, AreaVectorsOfAClosedSurfaceSumUpToZero) {
  const Icosphere sphere = make_icosphere(2);
  EXPECT_LT(face_area_vectors(ellipsoid(sphere), sphere.mesh.faces).rowwise().sum().norm(), 1e-13);
}

TEST(Geometry, VertexAreaVectorsAreTheGradientOfTheVolume) {
  const Icosphere sphere = make_icosphere(1);
  const Points x = ellipsoid(sphere);
  const Points gradient = vertex_area_vectors(x, sphere.mesh.faces);
  const double h = 1e-5;
  for (int vertex = 0; vertex < x.cols(); ++vertex)
    for (int axis = 0; axis < 3; ++axis) {
      Points forward = x, backward = x;
      forward(axis, vertex) += h;
      backward(axis, vertex) -= h;
      const double difference = volume(forward, sphere.mesh.faces) - volume(backward, sphere.mesh.faces);
      EXPECT_NEAR(gradient(axis, vertex), difference / (2 * h), 1e-10);
    }
}

TEST(Geometry, VertexAreasSumUpToTheArea) {
  const Icosphere sphere = make_icosphere(2);
  const Points x = ellipsoid(sphere);
  EXPECT_NEAR(vertex_areas(x, sphere.mesh.faces).sum(), area(x, sphere.mesh.faces), 1e-13);
}

TEST(Geometry, NormalsOfTheSphereArePositionsToFirstOrderInTheEdge) {
  for (int n : {3, 4, 5}) {
    const Icosphere sphere = make_icosphere(n);
    const Points error = vertex_normals(sphere.directions, sphere.mesh.faces) - sphere.directions;
    EXPECT_LT(error.colwise().norm().maxCoeff(), 0.1 * std::exp2(-n));
  }
}

TEST(Geometry, VolumeAreaAndInertiaOfTheEllipsoidConvergeWithTheSquareOfTheEdge) {
  const double exact_volume = 4 * pi / 3 * kSemiAxes.prod();
  const Eigen::Matrix3d exact_moments = exact_volume / 5 * kSemiAxes.cwiseAbs2().asDiagonal().toDenseMatrix();
  const Eigen::Matrix3d exact_inertia = exact_moments.trace() * Eigen::Matrix3d::Identity() - exact_moments;
  double previous_volume_error = 0, previous_inertia_error = 0;
  for (int n = 2; n <= 5; ++n) {
    const Icosphere sphere = make_icosphere(n);
    const Points x = ellipsoid(sphere);
    const double volume_error = std::abs(volume(x, sphere.mesh.faces) / exact_volume - 1);
    const double inertia_error = (inertia_tensor(x, sphere.mesh.faces) - exact_inertia).norm();
    if (n > 2) {
      EXPECT_NEAR(std::log2(previous_volume_error / volume_error), 2, 0.1);
      EXPECT_NEAR(std::log2(previous_inertia_error / inertia_error), 2, 0.1);
    }
    previous_volume_error = volume_error;
    previous_inertia_error = inertia_error;
  }
  EXPECT_LT(previous_volume_error, 2e-3);
}

TEST(Geometry, CentroidFollowsATranslation) {
  const Icosphere sphere = make_icosphere(2);
  EXPECT_LT((centroid(ellipsoid(sphere), sphere.mesh.faces) - kCentre).norm(), 1e-13);
}

TEST(Geometry, AreaOfTheSphereConvergesToFourPi) {
  const Icosphere sphere = make_icosphere(5);
  EXPECT_NEAR(area(sphere.directions, sphere.mesh.faces) / (4 * pi), 1, 1e-3);
}

}  // namespace
}  // namespace capstan
