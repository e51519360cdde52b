// What the coupling must keep exactly: rigid motion, volume, rest under pressure, symmetry of the mobility.
#include "solver/fluid/quasisteady/membrane_coupling.hpp"

#include <gtest/gtest.h>

#include <random>

#include "solver/grid/for_each_row.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

constexpr double kDx = 0.2;
const GridGeometry kGrid{Vec3::Constant(kDx / 2), kDx};

struct Capsule {
  Icosphere sphere = make_icosphere(3);
  Points positions = testing::bumped(sphere.directions, 0.03);
  Orbits whole = Orbits::without_symmetry(int(positions.cols()));

  MembraneCoupling coupling(double V) const {
    MembraneCoupling made(kGrid, sphere.mesh, whole, V, std::nullopt);
    EXPECT_TRUE(made.place(positions));
    return made;
  }
  Points random(unsigned seed) const {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    return Points::NullaryExpr(3, positions.cols(), [&] { return number(generator); });
  }
};

/// A field over the cells that the membrane touches.
template <class Value>
VectorField field_of(const MembraneCoupling& coupling, Value value) {
  VectorField field;
  field.reset(coupling.touched());
  for_each_row_in_order(field.box(), [&](int y, int z) {
    for (int i = 0; i < field.box().size(0); ++i) {
      const Vec3 vector = value(Vec3(kGrid.origin + kDx * Vec3(field.box().lo[0] + i, y, z)));
      for (int c = 0; c < 3; ++c) field.row(c, y, z)[i] = vector[c];
    }
  });
  return field;
}

TEST(MembraneCoupling, RigidMotionIsReadExactlyForEveryViscosityRatio) {
  const Capsule capsule;
  for (double V : {0.2, 1.0, 5.0}) {
    MembraneCoupling coupling = capsule.coupling(V);
    VectorField unused;
    coupling.spread(Points::Zero(3, capsule.positions.cols()), 1, unused);
    const Vec3 velocity(0.3, -0.2, 0.1), rotation(0.5, 0.7, -0.4);
    // the undisturbed flow (y, 0, 0), which read() adds, is taken out
    const VectorField field = field_of(
        coupling, [&](const Vec3& x) { return Vec3(velocity + rotation.cross(x) - Vec3(x[1], 0, 0)); });
    Points u;
    coupling.read(field, u);
    for (Eigen::Index k = 0; k < u.cols(); ++k)
      EXPECT_LT((u.col(k) - velocity - rotation.cross(Vec3(capsule.positions.col(k)))).norm(), 1e-11)
          << "V = " << V;
  }
}

TEST(MembraneCoupling, NoFlowCrossesTheMembrane) {
  const Capsule capsule;
  MembraneCoupling coupling = capsule.coupling(5);
  VectorField unused;
  coupling.spread(capsule.random(1), 1, unused);
  Points u;
  coupling.read(field_of(coupling, [](const Vec3& x) { return Vec3(x[0] * x[1], x[0], x[2] + 1); }), u);
  const double flux = u.cwiseProduct(vertex_area_vectors(capsule.positions, capsule.sphere.mesh.faces)).sum();
  EXPECT_NEAR(flux, 0, 1e-12);
}

TEST(MembraneCoupling, UniformPressureExertsNoForceOnTheGrid) {
  const Capsule capsule;
  MembraneCoupling coupling = capsule.coupling(5);
  VectorField field;
  coupling.spread(3 * vertex_area_vectors(capsule.positions, capsule.sphere.mesh.faces), 1, field);
  for (double number : field.values()) EXPECT_NEAR(number, 0, 1e-12);
}

TEST(MembraneCoupling, ForceAndTorqueOfTheMembraneReachTheGrid) {
  const Capsule capsule;
  const Points forces = capsule.random(2);
  for (double V : {0.2, 5.0}) {
    MembraneCoupling coupling = capsule.coupling(V);
    VectorField field;
    coupling.spread(forces, 1, field);
    Vec3 total = Vec3::Zero(), torque = Vec3::Zero();
    for_each_row_in_order(field.box(), [&](int y, int z) {
      for (int i = 0; i < field.box().size(0); ++i) {
        const Vec3 force(field.row(0, y, z)[i], field.row(1, y, z)[i], field.row(2, y, z)[i]);
        total += force;
        torque += Vec3(kGrid.origin + kDx * Vec3(field.box().lo[0] + i, y, z)).cross(force);
      }
    });
    EXPECT_LT((total - testing::total_force(forces)).norm(), 1e-10) << "V = " << V;
    EXPECT_LT((torque - testing::total_torque(capsule.positions, forces)).norm(), 1e-10) << "V = " << V;
  }
}

// With u = spread(F), <F', read(spread(F))> is symmetric in F and F': the mobility of the membrane is, as the
// fluid's is.
TEST(MembraneCoupling, TheMobilityIsSymmetric) {
  const Capsule capsule;
  const Points one = capsule.random(3), other = capsule.random(4);
  for (double V : {0.2, 1.0, 5.0}) {
    const auto velocities = [&](const Points& forces) {
      MembraneCoupling coupling = capsule.coupling(V);
      VectorField field;
      Points u, undisturbed;
      coupling.spread(Points::Zero(3, forces.cols()), 1, field);
      coupling.read(field, undisturbed);
      coupling.spread(forces, 1, field);
      coupling.read(field, u);
      return Points(u - undisturbed);
    };
    const double there = other.cwiseProduct(velocities(one)).sum();
    const double back = one.cwiseProduct(velocities(other)).sum();
    const double scale = one.cwiseProduct(velocities(one)).sum();
    EXPECT_NEAR(there, back, 1e-10 * scale) << "V = " << V;
    EXPECT_GT(scale, 0);
  }
}

}  // namespace
}  // namespace capstan
