// Exact Stokes flows around a unit sphere in a straining flow, computed with all parts of the lattice model:
// spreading, viscosity field, multigrid, interpolation.
//
// Let S = e_x e_y + e_y e_x; the rate of strain of the shear flow is S/2. Consider a sphere of viscosity
// ratio V with the force F S n per unit area on its surface. The velocity inside and on the surface is u =
// alpha S x. The tractions 2 V alpha S n inside and (5/2 - 3 alpha) S n outside balance the force, so that
// alpha = (5/2 + F) / (2 V + 3).
//
// Spreading and interpolation both smooth the kink of the velocity at the surface over the width of the delta
// function. This error is of first order; one Richardson extrapolation removes it. The rest is due to the
// walls and periodic images of the box of 6.4: 2.6 %, measured against a box of 12.8.
#include <gtest/gtest.h>

#include "solver/fluid/quasisteady/quasisteady_flow.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"

namespace capstan {
namespace {

/// S x.
Points strained(const Points& x) {
  Points u = Points::Zero(3, x.cols());
  u.row(0) = x.row(1);
  u.row(1) = x.row(0);
  return u;
}

/// alpha, from the velocities of the vertices.
double surface_strain(double V, double force, double dx) {
  const Icosphere sphere = make_icosphere(dx < 0.15 ? 4 : 3);
  const Points& x = sphere.directions;
  const Points s = strained(x);
  const Points forces = force * s * vertex_areas(x, sphere.mesh.faces).asDiagonal();
  Points u(3, x.cols());
  QuasisteadyFlow<double> flow(sphere.mesh, Orbits::of(x),
                               {.dx = dx, .box = 6.4, .Re = 0, .V = V, .tolerance = 1e-4});
  EXPECT_TRUE(flow.solve(0, x, forces, u).converged);
  return u.cwiseProduct(s).sum() / s.squaredNorm();
}

/// Relative errors of alpha at two spacings.
struct Errors {
  double coarse, fine;
  double extrapolated() const { return 2 * fine - coarse; }
};

Errors errors_of_drop(double V) {
  const double exact = 2.5 / (2 * V + 3);
  return {surface_strain(V, 0, 0.2) / exact - 1, surface_strain(V, 0, 0.1) / exact - 1};
}

/// Relative errors, at two spacings, of the part of alpha that the force adds at V = 1.
Errors errors_of_force() {
  const double exact = 1.0 / 5;
  return {(surface_strain(1, 1, 0.2) - 0.5) / exact - 1, (surface_strain(1, 1, 0.1) - 0.5) / exact - 1};
}

void expect_first_order(const Errors& errors) {
  EXPECT_NEAR(errors.coarse / errors.fine, 1.85, 0.2) << errors.coarse << ", " << errors.fine;
}

TEST(ExactStokes, SphereOfTheAmbientFluidFollowsTheShear) {
  EXPECT_NEAR(errors_of_drop(1).coarse, 0, 0.001);
  EXPECT_NEAR(errors_of_drop(1).fine, 0, 0.001);
}

// Measured, at 0.2 and 0.1: V = 0.2: -0.087, -0.048; V = 5: 0.297, 0.168.
TEST(ExactStokes, DropWithoutTensionStrainsByFiveOverTwoVPlusThree) {
  for (double V : {0.2, 5.0}) {
    const Errors errors = errors_of_drop(V);
    EXPECT_NEAR(errors.extrapolated(), 0, 0.05) << "V = " << V;
    expect_first_order(errors);
  }
}

// Measured: -0.279, -0.157. For a delta function of this width, spreading and interpolating, theory has
// -1.22 dx: the mean distance 0.82 dx of two points under it, halved, times the tangential share 0.6 of the
// kink 5 alpha.
TEST(ExactStokes, ForceOnASphereStrainsItByOneFifth) {
  const Errors errors = errors_of_force();
  EXPECT_NEAR(errors.extrapolated(), 0, 0.05);
  expect_first_order(errors);
}

}  // namespace
}  // namespace capstan
