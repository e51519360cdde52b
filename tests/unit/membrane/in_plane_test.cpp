#include "solver/membrane/in_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/membrane/neo_hookean.hpp"
#include "solver/membrane/skalak.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

using namespace capstan::testing;

struct Capsule {
  Icosphere sphere;
  InPlaneElasticity elasticity;

  Capsule(int subdivisions, std::unique_ptr<StrainLaw> law)
      : sphere(make_icosphere(subdivisions)),
        elasticity(sphere.mesh.faces, sphere.directions, std::move(law), 2.5) {}

  Points forces(const Points& positions) const {
    Points f = Points::Zero(3, positions.cols());
    elasticity.add_forces(positions, f);
    return f;
  }
};

std::unique_ptr<StrainLaw> law(bool skalak) {
  if (skalak) return std::make_unique<Skalak>(5);
  return std::make_unique<NeoHookean>();
}

class InPlane : public ::testing::TestWithParam<bool> {
 protected:
  Capsule capsule{2, law(GetParam())};
  /// Stretched, sheared and bumped.
  Points deformed() const {
    Eigen::Matrix3d shear;
    shear << 1.2, 0.5, 0, 0, 0.9, 0, 0.1, 0, 1.1;
    return bumped(shear * capsule.sphere.directions, 0.03);
  }
};

INSTANTIATE_TEST_SUITE_P(Laws, InPlane, ::testing::Bool(),
                         [](const auto& test) { return std::string(test.param ? "Skalak" : "NeoHookean"); });

TEST_P(InPlane, ForcesAreTheNegativeGradientOfTheEnergy) {
  const auto energy = [&](const Points& x) { return capsule.elasticity.energy(x); };
  const Points x = deformed();
  EXPECT_LT(relative_error(negative_gradient(energy, x), capsule.forces(x)), 1e-7);
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
  const Capsule fine(5, law(GetParam()));
  const Points x = radius * fine.sphere.directions, f = fine.forces(x);
  Principal stretch(1, 2);
  stretch << radius, radius;
  const double tension = 2.5 * law(GetParam())->derivatives(stretch)(0, 0) / radius;
  const Points area_vectors = vertex_area_vectors(x, fine.sphere.mesh.faces);
  const double pressure = -f.cwiseProduct(x).sum() / area_vectors.cwiseProduct(x).sum();
  EXPECT_NEAR(pressure / (2 * tension / radius), 1, 2e-3);
}

TEST(InPlaneStretches, OfAnAffineMapAreItsSingularValuesInEachPlane) {
  const Faces triangle = Eigen::Vector3i(0, 1, 2);
  Points flat(3, 3), stretched(3, 3);
  flat << 0, 1, 0.3, 0, 0, 0.8, 0, 0, 0;
  stretched = some_rotation() * Vec3(1.7, 0.6, 1).asDiagonal() * flat;
  const InPlaneElasticity one(triangle, flat, law(false), 1);
  EXPECT_NEAR(one.stretches(stretched)(0, 0), 1.7, 1e-14);
  EXPECT_NEAR(one.stretches(stretched)(0, 1), 0.6, 1e-14);
}

// Skalak's energy of a collapsed triangle is finite, a neo-Hookean one's is not.
TEST(InPlaneNeoHookean, ACollapsedTriangleShowsAsForcesThatAreNotFinite) {
  const Capsule capsule(2, law(false));
  Points x = capsule.sphere.directions;
  x.col(capsule.sphere.mesh.faces(1, 0)) = x.col(capsule.sphere.mesh.faces(0, 0));
  EXPECT_FALSE(capsule.forces(x).allFinite());
}

}  // namespace
}  // namespace capstan
