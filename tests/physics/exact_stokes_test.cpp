// Exact Stokes flows around a unit sphere in a straining flow, computed with all parts of the lattice model:
// spreading, viscosity field, multigrid, reading.
//
// Let S = e_x e_y + e_y e_x; the rate of strain of the shear flow is S/2. A sphere of viscosity ratio V
// carries a normal load, a n (n.S n) per unit area, or a tangential one, (I - n n) S n. With N = n (n.S n)
// and T = S n - N on the surface, the flows of second degree are
//   inside   c0 S x + c1 (5 r^2 S x - 2 x (x.S x)),          u = (c0 + 3 c1) N + (c0 + 5 c1) T,
//            traction V [(2 c0 - 3 c1) N + (2 c0 + 16 c1) T],
//   outside  c2 x (x.S x)/r^5 + c3 (2 S x/r^5 - 5 x (x.S x)/r^7),
//            u = (c2 - 3 c3) N + 2 c3 T,  traction (-6 c2 + 24 c3) N + (2 c2 - 16 c3) T.
// Without a load the drop strains by 5/(2 V + 3) of the undisturbed strain.
//
// The box of 25.6 changes these by less than 0.1 %.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "solver/fluid/quasisteady/quasisteady_flow.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"

namespace capstan {
namespace {

enum Load { kNormal, kTangential };

/// Velocities along N and T under a load.
std::array<double, 2> exact_velocities(double V, Load load) {
  Eigen::Matrix4d M;
  M << 2 * V, -3 * V, 6, -24, 2 * V, 16 * V, -2, 16, 1, 5, 0, -2, 1, 3, -1, 3;
  const Eigen::Vector4d c = M.fullPivLu().solve(Eigen::Vector4d(load == kNormal, load == kTangential, 0, 0));
  return {c[0] + 3 * c[1], c[0] + 5 * c[1]};
}

class Drop {
 public:
  Drop(double V, double dx)
      : V_(V),
        sphere_(make_icosphere(dx < 0.15  ? 4
                               : dx < 0.3 ? 3
                                          : 2)),
        flow_(sphere_.mesh, Orbits::of(x()),
              {.dx = dx, .box = 25.6, .Re = 0, .V = V, .volume = std::nullopt, .tolerance = 1e-6}),
        normal_(3, x().cols()),
        tangential_(3, x().cols()) {
    for (Eigen::Index k = 0; k < x().cols(); ++k) {
      const Vec3 n = x().col(k), strained(n[1], n[0], 0);
      normal_.col(k) = n * n.dot(strained);
      tangential_.col(k) = strained - normal_.col(k);
    }
    EXPECT_TRUE(flow_.solve(0, x(), Points::Zero(3, x().cols()), free_).converged);
  }

  /// Error of the strain without a load, relative to it.
  double error_of_strain() const {
    const Points strained = normal_ + tangential_;
    const double exact = 2.5 / (2 * V_ + 3);
    return free_.cwiseProduct(strained).sum() / strained.squaredNorm() / exact - 1;
  }

  /// The larger error of the velocities along N and T under a load, relative to the larger velocity.
  double error_under(Load load) {
    const Points forces =
        (load == kNormal ? normal_ : tangential_) * vertex_areas(x(), sphere_.mesh.faces).asDiagonal();
    Points u(3, x().cols());
    EXPECT_TRUE(flow_.solve(0, x(), forces, u).converged);
    u -= free_;
    const auto [along_N, along_T] = exact_velocities(V_, load);
    const double N = u.cwiseProduct(normal_).sum() / normal_.squaredNorm() - along_N;
    const double T = u.cwiseProduct(tangential_).sum() / tangential_.squaredNorm() - along_T;
    return std::max(std::abs(N), std::abs(T)) / std::max(std::abs(along_N), std::abs(along_T));
  }

 private:
  const Points& x() const { return sphere_.directions; }
  double V_;
  Icosphere sphere_;
  QuasisteadyFlow<double> flow_;
  Points normal_, tangential_;  ///< N and T at the vertices
  Points free_;                 ///< velocities without a load
};

TEST(ExactStokes, SphereOfTheAmbientFluidFollowsTheShear) {
  EXPECT_NEAR(Drop(1, 0.2).error_of_strain(), 0, 1e-4);
}

double order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

// Measured in percent at dx = 0.4, 0.2, 0.1 and 0.05: V = 0.2: 3.5, 1.2, 0.36, 0.13; V = 5: 13, 3.9, 1.5,
// 0.48; V = 10: 28, 7.7, 2.7, 0.85. The order is 1.5 to 1.8: an error of first order is left, which single
// directions of the membrane have (membrane_layer.hpp).
TEST(ExactStokes, ViscousDropWithoutALoadStrainsByFiveOverTwoVPlusThreeWithAnOrderOfThreeHalves) {
  for (double V : {5.0, 10.0})
    EXPECT_GT(order(Drop(V, 0.2).error_of_strain(), Drop(V, 0.05).error_of_strain()), 2 * 1.5) << "V = " << V;
  EXPECT_NEAR(Drop(5, 0.1).error_of_strain(), 0, 0.015);
  EXPECT_NEAR(Drop(10, 0.2).error_of_strain(), 0, 0.08);
}

TEST(ExactStokes, ThinDropWithoutALoadStrainsRightToHalfAPercent) {
  EXPECT_NEAR(Drop(0.2, 0.1).error_of_strain(), 0, 0.005);
}

/// Expects that a sphere of the ambient fluid moves under a load with an error of second order. Returns the
/// error at dx = 0.1.
double expect_second_order(Load load) {
  Drop coarse(1, 0.4), middle(1, 0.2), fine(1, 0.1);
  const double errors[] = {coarse.error_under(load), middle.error_under(load), fine.error_under(load)};
  EXPECT_GT(order(errors[0], errors[1]), 1.8);
  EXPECT_GT(order(errors[1], errors[2]), 1.8);
  return errors[2];
}

// Measured at dx = 0.4, 0.2, 0.1: 4.7, 0.56, 0.07 %.
TEST(ExactStokes, NormalLoadMovesTheSphereOfTheAmbientFluidToSecondOrder) {
  EXPECT_LT(expect_second_order(kNormal), 0.002);
}

// Measured at dx = 0.1: 0.2, 0.6, 0.6 % at V = 0.2, 5, 10.
TEST(ExactStokes, NormalLoadMovesADropToOnePercent) {
  for (double V : {0.2, 5.0, 10.0}) EXPECT_LT(Drop(V, 0.1).error_under(kNormal), 0.01) << "V = " << V;
}

// Measured at dx = 0.4, 0.2, 0.1: 9.0, 1.5, 0.23 %.
TEST(ExactStokes, TangentialLoadMovesTheSphereOfTheAmbientFluidToSecondOrder) {
  EXPECT_LT(expect_second_order(kTangential), 0.01);
}

// Measured in percent at dx = 0.2, 0.1 and 0.05: V = 0.2: 4.6, 1.2, 0.34; V = 5: 1.8, 1.0, 0.5; V = 10: 5.6,
// 2.4, 1.0.
TEST(ExactStokes, TangentialLoadMovesADropToAFewPercent) {
  EXPECT_LT(Drop(5, 0.1).error_under(kTangential), 0.015);
  EXPECT_LT(Drop(10, 0.1).error_under(kTangential), 0.03);
}

TEST(ExactStokes, TangentialLoadMovesAThinDropToSecondOrder) {
  const double coarse = Drop(0.2, 0.2).error_under(kTangential),
               fine = Drop(0.2, 0.1).error_under(kTangential);
  EXPECT_GT(order(coarse, fine), 1.8);
  EXPECT_LT(fine, 0.015);
}

}  // namespace
}  // namespace capstan
