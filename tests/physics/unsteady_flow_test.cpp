// Unsteady flow around a membrane on the composite grid: an exact solution, the order in the time step, the
// limit of small inertia.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/fluid/quasisteady/quasisteady_flow.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"

namespace capstan {
namespace {

using std::numbers::pi;

/// Mean velocity of a sphere on whose surface a force 6 pi along z is distributed evenly, from t = 0 on, in
/// fluid at rest; in units of Stokes' velocity. The flow of a force with the Fourier transform f is (I - k
/// k/k^2) f (1
/// - exp(-k^2 t/Re))/k^2, and the transform of the evenly covered sphere is sin(k)/k. So
///   U(t) = 2/pi int_0^infinity (sin(k)/k)^2 (1 - exp(-k^2 t/Re)) dk.
double velocity_of_pushed_sphere(double t_over_Re) {
  const double step = 1e-3;
  double sum = 0;
  for (double k = step / 2; k < 100; k += step)
    sum += std::pow(std::sin(k) / k, 2) * (1 - std::exp(-k * k * t_over_Re)) * step;
  return 2 / pi * sum;
}

// The width of the delta function reduces the velocity by a part that is constant from t/Re = 0.2 on: the
// increase from there is compared. Re is so small that the shear flow does not move the fluid meanwhile.
// Measured: 0.026.
TEST(UnsteadyFlow, PushedSphereAcceleratesAsInUnboundedFluid) {
  constexpr double kRe = 1e-3;
  const Icosphere sphere = make_icosphere(3);
  const Points& x = sphere.directions;
  const Eigen::RowVectorXd areas = vertex_areas(x, sphere.mesh.faces).transpose();
  Points forces = Points::Zero(3, x.cols()), u;
  forces.row(2) = 6 * pi / areas.sum() * areas;
  QuasisteadyFlow<float> flow(sphere.mesh, Orbits::without_symmetry(int(x.cols())),
                              {.dx = 0.2, .Re = kRe, .is_unsteady = true});
  std::vector<double> velocities;
  for (int step = 0; step <= 40; ++step) {
    EXPECT_TRUE(flow.solve(0.025 * step * kRe, x, forces, u).converged);
    velocities.push_back(u.row(2).dot(areas) / areas.sum());
  }
  EXPECT_EQ(velocities[0], 0);
  for (int step : {16, 24, 32, 40}) {
    const double exact = velocity_of_pushed_sphere(0.025 * step) - velocity_of_pushed_sphere(0.2);
    EXPECT_NEAR(velocities[step] - velocities[8], exact, 0.05 * exact) << "step " << step;
  }
}

/// (e_x e_y + e_y e_x) x: a velocity of pure strain.
Points strain(const Points& x) {
  Points u = Points::Zero(3, x.cols());
  u.row(0) = x.row(1), u.row(1) = x.row(0);
  return u;
}

Points straining_forces(const Icosphere& sphere) {
  return strain(sphere.directions) * vertex_areas(sphere.directions, sphere.mesh.faces).asDiagonal();
}

/// Strain of the surface of a sphere at kt = 0.4, under a straining force that grows as t^2.
double strain_at_end(int steps, double Re, bool is_unsteady, double V = 4) {
  const Icosphere sphere = make_icosphere(2);
  const Points &x = sphere.directions, forces = straining_forces(sphere);
  Points u;
  QuasisteadyFlow<double> flow(
      sphere.mesh, Orbits::of(x),
      {.dx = 0.4, .box = 6.4, .Re = Re, .V = V, .tolerance = 1e-9, .is_unsteady = is_unsteady});
  for (int step = 0; step <= steps; ++step) {
    const double t = 0.4 * step / steps;
    EXPECT_TRUE(flow.solve(t, x, t * t * forces, u).converged);
  }
  return u.cwiseProduct(strain(x)).sum() / x.topRows(2).squaredNorm();
}

TEST(UnsteadyFlow, IsOfSecondOrderInTheTimeStep) {
  const double coarse = strain_at_end(32, 0.5, true), medium = strain_at_end(64, 0.5, true),
               fine = strain_at_end(128, 0.5, true);
  EXPECT_NEAR(std::log2((coarse - medium) / (medium - fine)), 2, 0.25);
}

// With a density that is extrapolated as the momentum is, errors grow: see MomentGrid::density_weight().
TEST(UnsteadyFlow, ErrorsDecayFromStepToStepWithOneCycleAStep) {
  const Icosphere sphere = make_icosphere(2);
  const Points &x = sphere.directions, forces = -straining_forces(sphere);
  for (double V : {0.2, 1.0, 5.0}) {
    QuasisteadyFlow<double> flow(
        sphere.mesh, Orbits::of(x),
        {.dx = 0.4, .box = 12.8, .Re = 1, .V = V, .tolerance = 1e300, .is_unsteady = true});
    Points u, last;
    for (int step = 0; step <= 200; ++step) {
      last = u;
      EXPECT_LE(flow.solve(0.02 * step, x, forces, u).iterations, 1);
    }
    EXPECT_LT((u - last).norm(), 1e-4 * u.norm()) << "V = " << V;
  }
}

TEST(UnsteadyFlow, IsQuasisteadyWithoutInertia) {
  EXPECT_NEAR(strain_at_end(8, 1e-6, true), strain_at_end(8, 1e-6, false), 1e-6);
}

// Measured: 0.0104.
TEST(UnsteadyFlow, DiffersFromQuasisteadyWithInertia) {
  EXPECT_LT(strain_at_end(8, 0.5, true, 1), strain_at_end(8, 0.5, false, 1) - 0.008);
}

}  // namespace
}  // namespace capstan
