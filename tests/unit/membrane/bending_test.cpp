#include "solver/membrane/bending.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"
#include "solver/mesh/shapes.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

using namespace capstan::testing;
using std::numbers::pi;

constexpr double kModulus = 0.7;

Case bending_case(BendingModel model, SpontaneousCurvature c0, Shape shape = Shape::sphere) {
  Case c;
  c.shape = shape;
  c.E_b = 0.01;
  c.bending = model;
  c.c0 = c0;
  return c;
}

struct BentCapsule {
  Icosphere sphere;
  Points initial;
  std::unique_ptr<Bending> bending;

  BentCapsule(int subdivisions, const Case& c)
      : sphere(make_icosphere(subdivisions)),
        initial(initial_positions(c, sphere)),
        bending(make_bending(c, sphere.mesh, spontaneous_curvature(c, sphere.mesh, initial), kModulus)) {}

  Points forces(const Points& x) const {
    Points f = Points::Zero(3, x.cols());
    bending->add_forces(x, f);
    return f;
  }

  /// Mean over the surface of the force per area along the outward normal.
  double mean_normal_load(const Points& x) const {
    const Points normals = vertex_normals(x, sphere.mesh.faces);
    return forces(x).cwiseProduct(normals).sum() / area(x, sphere.mesh.faces);
  }
};

const SpontaneousCurvature kEveryC0[] = {InitialCurvature{}, 0.0, -1.5, 2.0};

TEST(VariationalBending, ForcesAreTheNegativeGradientOfTheEnergy) {
  for (const SpontaneousCurvature& c0 : kEveryC0) {
    const BentCapsule capsule(2, bending_case(BendingModel::variational, c0, Shape::biconcave));
    const auto energy = [&](const Points& x) { return *capsule.bending->energy(x); };
    const Points x = bumped(capsule.initial, 0.02);
    EXPECT_LT(relative_error(negative_gradient(energy, x), capsule.forces(x)), 1e-7);
  }
}

TEST(VariationalBending, TheInitialShapeIsAtRestWithItsOwnCurvature) {
  const BentCapsule capsule(3, bending_case(BendingModel::variational, InitialCurvature{}, Shape::biconcave));
  EXPECT_LT(capsule.forces(capsule.initial).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(VariationalBending, TotalForceAndTorqueAreZero) {
  const BentCapsule capsule(3, bending_case(BendingModel::variational, 1.0, Shape::biconcave));
  const Points x = bumped(capsule.initial, 0.01), f = capsule.forces(x);
  EXPECT_LT(total_force(f).norm() / f.norm(), 1e-13);
  EXPECT_LT(total_torque(x, f).norm() / f.norm(), 1e-13);
}

TEST(VariationalBending, ForcesTurnWithTheCapsule) {
  const BentCapsule capsule(2, bending_case(BendingModel::variational, InitialCurvature{}, Shape::biconcave));
  const Points x = bumped(capsule.initial, 0.02);
  const Points turned_forces = some_rotation() * capsule.forces(x);
  EXPECT_LT(relative_error(turned_forces, capsule.forces(some_rotation() * x)), 1e-11);
}

TEST(VariationalBending, EnergyWithoutSpontaneousCurvatureDoesNotDependOnSize) {
  const BentCapsule capsule(3, bending_case(BendingModel::variational, 0.0, Shape::biconcave));
  const double energy = *capsule.bending->energy(capsule.initial);
  EXPECT_NEAR(*capsule.bending->energy(3 * capsule.initial) / energy, 1, 1e-13);
  EXPECT_NEAR(capsule.forces(capsule.initial).cwiseProduct(capsule.initial).sum() / energy, 0, 1e-12);
}

TEST(VariationalBending, EnergyOfTheSphereConvergesToEightPi) {
  const BentCapsule capsule(5, bending_case(BendingModel::variational, 0.0));
  EXPECT_NEAR(*capsule.bending->energy(capsule.initial) / (8 * pi * kModulus), 1, 5e-3);
}

class EveryBendingModel : public ::testing::TestWithParam<BendingModel> {};
INSTANTIATE_TEST_SUITE_P(Each, EveryBendingModel,
                         ::testing::Values(BendingModel::variational, BendingModel::helfrich_literal),
                         [](const auto& test) { return std::string(to_string(test.param)); });

// The first variation of Helfrich's energy on a sphere of radius R pushes outwards with  E_B (2/R - c0) c0 /
// R  per area, and vanishes for c0 = 0 (E does not depend on size) and for c0 = 2/R.
TEST_P(EveryBendingModel, LoadOnASphereIsThatOfHelfrichsVariation) {
  for (double c0 : {0.0, 1.0, 2.0, 3.0, -1.0}) {
    const BentCapsule capsule(4, bending_case(GetParam(), c0));
    const double exact = kModulus * (2 - c0) * c0;
    EXPECT_NEAR(capsule.mean_normal_load(capsule.initial), exact, 0.02 * kModulus * (1 + c0 * c0))
        << "c0 = " << c0;
  }
}

TEST_P(EveryBendingModel, SpheroidWithoutSpontaneousCurvatureIsDrivenTowardsTheSphere) {
  Case c = bending_case(GetParam(), 0.0, Shape::oblate);
  c.aspect = 0.6;
  const BentCapsule capsule(3, c);
  const Vec3 axis = Vec3(-1, 1, 0).normalized();
  const Points f = capsule.forces(capsule.initial);
  const Scalars heights = capsule.initial.transpose() * axis;
  EXPECT_GT((f.transpose() * axis).dot(heights), 0);  // the poles are pushed apart
}

TEST(LiteralBending, HasNoEnergy) {
  const BentCapsule capsule(1, bending_case(BendingModel::helfrich_literal, 0.0));
  EXPECT_FALSE(capsule.bending->energy(capsule.initial));
}

TEST(LiteralBending, AgreesWithTheVariationWhereTheSpontaneousCurvatureIsUniform) {
  Case c = bending_case(BendingModel::helfrich_literal, 1.0, Shape::oblate);
  c.aspect = 0.8;
  const BentCapsule literal(5, c);
  c.bending = BendingModel::variational;
  const BentCapsule variational(5, c);
  const auto squeezing = [](const BentCapsule& capsule) {  // power in a motion that flattens the spheroid
    const Vec3 axis = Vec3(-1, 1, 0).normalized();
    const Points& x = capsule.initial;
    const Points flattening = x - 3 * axis * (axis.transpose() * x);
    return capsule.forces(x).cwiseProduct(flattening).sum();
  };
  EXPECT_NEAR(squeezing(literal) / squeezing(variational), 1, 0.02);
}

TEST(Bending, IsLeftOutWithoutStiffness) {
  const Icosphere sphere = make_icosphere(1);
  EXPECT_EQ(make_bending(Case{}, sphere.mesh, Scalars::Zero(sphere.mesh.vertex_count()), 0), nullptr);
}

}  // namespace
}  // namespace capstan
