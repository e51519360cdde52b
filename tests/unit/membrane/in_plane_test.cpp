#include "solver/membrane/in_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"
#include "tests/support/materials.hpp"

namespace capstan {
namespace {

using namespace capstan::testing;

struct Capsule {
  Icosphere sphere;
  InPlaneElasticity elasticity;

  Capsule(int subdivisions, const Material& material)
      : sphere(make_icosphere(subdivisions)),
        elasticity(sphere.mesh.faces, sphere.directions, *material.law, material.constants, 2.5) {}

  Points forces(const Points& positions) const {
    Points f = Points::Zero(3, positions.cols());
    elasticity.add_forces(positions, f);
    return f;
  }
};

Material neo_hookean() { return {find_strain_law("neo-hookean"), {}}; }

class InPlane : public ::testing::TestWithParam<Material> {
 protected:
  Capsule capsule{2, GetParam()};
  /// Stretched, sheared and bumped.
  Points deformed() const {
    Eigen::Matrix3d shear;
    shear << 1.2, 0.5, 0, 0, 0.9, 0, 0.1, 0, 1.1;
    return bumped(shear * capsule.sphere.directions, 0.03);
  }
};

INSTANTIATE_TEST_SUITE_P(EachStrainLaw, InPlane, ::testing::ValuesIn(all_materials()),
                         [](const auto& test) { return name_of(test.param); });

TEST_P(InPlane, ForcesAreTheNegativeGradientOfTheEnergy) {
  const auto energy = [&](const Points& x) { return capsule.elasticity.energy(x); };
  const Points x = deformed();
  EXPECT_LT(relative_error(negative_gradient(energy, x), capsule.forces(x)), 1e-7);
}

TEST_P(InPlane, StretchAtTheVerticesOfAHomogeneousDeformationIsThatOfTheFaces) {
  const Points x = Vec3(2, 2, 2).asDiagonal() * capsule.sphere.directions;
  EXPECT_LT((capsule.elasticity.vertex_stretches(x).array() - 2).abs().maxCoeff(), 1e-12);
}

TEST_P(InPlane, StretchAtAVertexLiesBetweenThoseOfItsFaces) {
  const Points x = deformed();
  const Principal of_faces = capsule.elasticity.stretches(x);
  const Scalars at_vertices = capsule.elasticity.vertex_stretches(x);
  EXPECT_LE(at_vertices.maxCoeff(), of_faces.col(0).maxCoeff());
  EXPECT_GE(at_vertices.minCoeff(), of_faces.col(0).minCoeff());
}

TEST_P(InPlane, ForcesVanishAtRestHoweverItIsTurnedAndMoved) {
  const Points moved = (some_rotation() * capsule.sphere.directions).colwise() + Vec3(3, -1, 2);
  EXPECT_LT(capsule.forces(moved).cwiseAbs().maxCoeff(), 1e-13);
}

TEST_P(InPlane, ForcesTurnWithTheCapsule) {
  const Points x = deformed();
  const Points turned_forces = some_rotation() * capsule.forces(x);
  EXPECT_LT(relative_error(turned_forces, capsule.forces(some_rotation() * x)), 1e-12);
}

TEST_P(InPlane, TotalForceAndTorqueAreZero) {
  const Points x = deformed(), f = capsule.forces(x);
  EXPECT_LT(total_force(f).norm(), 1e-12);
  EXPECT_LT(total_torque(x, f).norm(), 1e-12);
}

TEST_P(InPlane, AnInflatedSpherePressesInwardsWithTwiceItsTensionOverTheRadius) {
  const double radius = 1.3;
  const Capsule fine(5, GetParam());
  const Points x = radius * fine.sphere.directions, f = fine.forces(x);
  Principal stretch(1, 2);
  stretch << radius, radius;
  const double tension = 2.5 * GetParam().law->derivatives(stretch, GetParam().constants)(0, 0) / radius;
  const Points area_vectors = vertex_area_vectors(x, fine.sphere.mesh.faces);
  const double pressure = -f.cwiseProduct(x).sum() / area_vectors.cwiseProduct(x).sum();
  EXPECT_NEAR(pressure / (2 * tension / radius), 1, 2e-3);
}

TEST(InPlaneStretches, OfAnAffineMapAreItsSingularValuesInEachPlane) {
  const Faces triangle = Eigen::Vector3i(0, 1, 2);
  Points flat(3, 3), stretched(3, 3);
  flat << 0, 1, 0.3, 0, 0, 0.8, 0, 0, 0;
  stretched = some_rotation() * Vec3(1.7, 0.6, 1).asDiagonal() * flat;
  const InPlaneElasticity one(triangle, flat, *neo_hookean().law, {}, 1);
  EXPECT_NEAR(one.stretches(stretched)(0, 0), 1.7, 1e-14);
  EXPECT_NEAR(one.stretches(stretched)(0, 1), 0.6, 1e-14);
}

// Skalak's energy of a collapsed triangle is finite, a neo-Hookean one's is not.
TEST(InPlaneNeoHookean, ACollapsedTriangleShowsAsForcesThatAreNotFinite) {
  const Capsule capsule(2, neo_hookean());
  Points x = capsule.sphere.directions;
  x.col(capsule.sphere.mesh.faces(1, 0)) = x.col(capsule.sphere.mesh.faces(0, 0));
  EXPECT_FALSE(capsule.forces(x).allFinite());
}

}  // namespace
}  // namespace capstan
