#include "solver/fluid/stokes/stokes_flow.hpp"

#include <gtest/gtest.h>

#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"
#include "solver/mesh/shapes.hpp"
#include "tests/support/test_names.hpp"

namespace capstan {
namespace {

Points solved(StokesFlow flow, const Points& positions, const Points& forces) {
  Points velocities(3, positions.cols());
  EXPECT_TRUE(flow.solve(0, positions, forces, velocities).converged);
  return velocities;
}

StokesFlow flow_around(const TriangleMesh& mesh, const Points& positions, double V, Orbits orbits) {
  return {mesh, std::move(orbits), {.V = V, .volume = volume(positions, mesh.faces), .tolerance = 1e-6}};
}
StokesFlow flow_around(const TriangleMesh& mesh, const Points& positions, double V) {
  return flow_around(mesh, positions, V, Orbits::of(positions));
}

/// Rate of strain in the plane of shear of velocities on the unit sphere: a weighted mean of u_x / y and u_y
/// / x.
double strain_rate(const Points& directions, const Points& velocities) {
  const auto x = directions.row(0), y = directions.row(1);
  return (velocities.row(0).dot(y) + velocities.row(1).dot(x)) / (x.squaredNorm() + y.squaredNorm());
}

class Drop : public ::testing::TestWithParam<double> {};

// Taylor 1932: the surface of a sphere without tension strains at 5/(2V + 3) times the rate of the shear
// flow, 1/2.
TEST_P(Drop, WithoutTensionStrainsAsInTaylorsSolution) {
  const double V = GetParam();
  const Icosphere sphere = make_icosphere(3);
  const Points u =
      solved(flow_around(sphere.mesh, sphere.directions, V), sphere.directions, Points::Zero(3, 642));
  EXPECT_NEAR(strain_rate(sphere.directions, u) / (0.5 * 5 / (2 * V + 3)), 1, 0.015);
}
INSTANTIATE_TEST_SUITE_P(Drops, Drop, ::testing::Values(0.1, 1, 5, 20), testing::number_names("V"));

// With V = 1 a force F, spread evenly over the sphere, moves it at 1/(8 pi) int G F/(4 pi) dA = F / (6 pi):
// Stokes' law.
TEST(StokesFlow, AUniformForceMovesTheSphereByStokesLaw) {
  const Icosphere sphere = make_icosphere(3);
  Points at_rest = sphere.directions;
  const Vec3 force(0, 0, 2);
  const Points forces = force / (4 * std::numbers::pi) * vertex_areas(at_rest, sphere.mesh.faces).transpose();
  const Points u =
      solved(flow_around(sphere.mesh, at_rest, 1, Orbits::without_symmetry(642)), at_rest, forces);
  EXPECT_NEAR(u.row(2).mean() * 6 * std::numbers::pi / force.z(), 1, 0.01);
}

TEST(StokesFlow, AUniformPressureDrivesNoFlow) {
  const Icosphere sphere = make_icosphere(3);
  const Points cell = biconcave(sphere.directions);
  const Points pressure = 7 * vertex_area_vectors(cell, sphere.mesh.faces), none = Points::Zero(3, 642);
  const Points with = solved(flow_around(sphere.mesh, cell, 4), cell, pressure);
  const Points without = solved(flow_around(sphere.mesh, cell, 4), cell, none);
  EXPECT_LT((with - without).norm(), 1e-5 * without.norm());
}

Case inclined_cell() {
  Case c;
  c.shape = Shape::biconcave;
  return c;
}

/// Forces with the symmetry of the flow, which those of a membrane have.
Points some_forces(const Points& positions) {
  Eigen::Matrix3d A;
  A << 0.3, 0.1, 0, -0.2, 0.1, 0, 0, 0, -0.4;
  return 0.01 * A * positions;
}

TEST(StokesFlow, OnAQuarterIsThatOnTheWholeMembrane) {
  const Icosphere sphere = make_icosphere(3);
  const Points cell = initial_positions(inclined_cell(), sphere), forces = some_forces(cell);
  const Points quarter = solved(flow_around(sphere.mesh, cell, 4), cell, forces);
  const Points whole = solved(flow_around(sphere.mesh, cell, 4, Orbits::without_symmetry(642)), cell, forces);
  EXPECT_LT((quarter - whole).norm(), 1e-5 * whole.norm());
}

TEST(StokesFlow, ADeviationOfTheVolumeDecaysAtTheRateTen) {
  const Icosphere sphere = make_icosphere(3);
  const Points swollen = 1.01 * sphere.directions;
  const double wished = volume(sphere.directions, sphere.mesh.faces),
               drift = volume(swollen, sphere.mesh.faces) - wished;
  StokesFlow flow(sphere.mesh, Orbits::of(swollen), {.V = 3, .volume = wished});
  const Points u = solved(std::move(flow), swollen, Points::Zero(3, 642));
  const double rate = u.cwiseProduct(vertex_area_vectors(swollen, sphere.mesh.faces)).sum();
  EXPECT_NEAR(rate, -10 * drift, 1e-6 * drift);
}

TEST(StokesFlow, ReportsAReasonForForcesThatAreNotFinite) {
  const Icosphere sphere = make_icosphere(2);
  Points velocities(3, 162);
  const FlowReport report = flow_around(sphere.mesh, sphere.directions, 2)
                                .solve(0, sphere.directions, Points::Constant(3, 162, NAN), velocities);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}

}  // namespace
}  // namespace capstan
