// The single and the double layer: their eigenfunctions on the unit sphere (Kim and Karrila 1991, chapter 4),
// and their invariants on other surfaces.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numeric>

#include "solver/fluid/stokes/double_layer.hpp"
#include "solver/fluid/stokes/single_layer.hpp"
#include "solver/mesh/icosphere.hpp"
#include "solver/mesh/shapes.hpp"

namespace capstan {
namespace {

std::vector<int> all_vertices(const TriangleMesh& mesh) {
  std::vector<int> vertices(size_t(mesh.vertex_count()));
  std::iota(vertices.begin(), vertices.end(), 0);
  return vertices;
}

/// Both operators on a surface, with all vertices as targets.
struct Operators {
  Operators(const TriangleMesh& mesh, const Points& positions_)
      : positions(positions_),
        surface(mesh, positions),
        neighbourhood(mesh, all_vertices(mesh)),
        close(neighbourhood.close_faces(surface)) {}

  /// Velocity by a force per area.
  Points single_layer(const Points& density) const {
    return of_forces(density * surface.vertex_areas.asDiagonal());
  }
  Points of_forces(const Points& forces) const {
    return capstan::single_layer(surface, neighbourhood, close, forces);
  }
  Points double_layer(const Points& velocities) const {
    return DoubleLayer(surface, neighbourhood, close).apply(velocities);
  }

  Points positions;
  Surface surface;
  Neighbourhood neighbourhood;
  std::vector<CloseFace> close;
};

Operators sphere_of(const Icosphere& sphere) { return {sphere.mesh, sphere.directions}; }

Eigen::Matrix3d a_rotation() {
  Eigen::Matrix3d W;
  W << 0, -0.3, 0.2, 0.3, 0, -0.5, -0.2, 0.5, 0;
  return W;
}

Eigen::Matrix3d a_strain() {
  Eigen::Matrix3d E;
  E << 0.2, 0.5, 0.1, 0.5, -0.6, 0.3, 0.1, 0.3, 0.4;
  return E;
}

double relative_difference(const Points& a, const Points& b) { return (a - b).norm() / b.norm(); }

// Tractions on a rigid sphere of radius 1 in a fluid of viscosity 1: 3/2 U in translation, 3 W x in rotation,
// 5 E x in a strain.
TEST(SingleLayer, HasTheEigenvaluesOfTheSphere) {
  const Icosphere sphere = make_icosphere(3);
  const Operators on = sphere_of(sphere);
  const Points translation = Vec3(1, 2, 3).replicate(1, 642);
  const Points rotation = a_rotation() * sphere.directions, strain = a_strain() * sphere.directions;
  EXPECT_LT(relative_difference(on.single_layer(1.5 * translation), translation), 0.003);
  EXPECT_LT(relative_difference(on.single_layer(3 * rotation), rotation), 0.003);
  EXPECT_LT(relative_difference(on.single_layer(5 * strain), strain), 0.003);
}

TEST(DoubleLayer, OfARigidMotionIsZeroOnAnySurface) {
  const Icosphere sphere = make_icosphere(3);
  const Operators on(sphere.mesh, biconcave(sphere.directions));
  const Points motion = (a_rotation() * on.positions).colwise() + Vec3(1, 2, 3);
  EXPECT_LT(on.double_layer(motion).norm(), 2e-6 * motion.norm());
}

TEST(DoubleLayer, OfAStrainOfTheSphereConvergesToTwoFifthsOfItAtSecondOrder) {
  std::vector<double> errors;
  for (int subdivisions : {2, 3, 4}) {
    const Icosphere sphere = make_icosphere(subdivisions);
    const Points strain = a_strain() * sphere.directions;
    errors.push_back(relative_difference(sphere_of(sphere).double_layer(strain), 0.4 * strain));
  }
  EXPECT_LT(errors[1], 0.01);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.2);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.2);
}

/// The smallest eigenvalue of the symmetric part of the matrix from forces to velocities, over the mean of
/// all eigenvalues.
double smallest_eigenvalue(const Operators& on) {
  const Eigen::Index size = 3 * on.positions.cols();
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index n = 0; n < size; ++n)
    matrix.col(n) = on.of_forces(Eigen::VectorXd::Unit(size, n).reshaped(3, size / 3)).reshaped();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (matrix + matrix.transpose()),
                                                              Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() / solver.eigenvalues().mean();
}

// Forces always do positive work on the fluid. If a discrete operator violates this, elements collapse.
TEST(SingleLayer, IsPositiveOnStretchedElements) {
  const Icosphere sphere = make_icosphere(2);
  for (const Vec3& stretches : {Vec3(1, 1, 1), Vec3(3, 0.6, 0.6), Vec3(0.5, 0.5, 3), Vec3(1.5, 1.5, 0.5)})
    EXPECT_GT(smallest_eigenvalue({sphere.mesh, stretches.asDiagonal() * sphere.directions}), 0.01)
        << stretches.transpose();
}

TEST(SingleLayer, IsPositiveOnARedBloodCell) {
  const Icosphere sphere = make_icosphere(2);
  EXPECT_GT(smallest_eigenvalue({sphere.mesh, biconcave(sphere.directions)}), 0.01);
}

/// A red blood cell whose dimples nearly touch: its thickness is multiplied by `thickness`.
Points pinched(const Points& directions, double thickness) {
  Points positions = biconcave(directions);
  positions.row(1) *= thickness;
  return positions;
}

TEST(CloseFaces, AreNoneOnARegularMesh) {
  const Icosphere sphere = make_icosphere(3);
  EXPECT_TRUE(sphere_of(sphere).close.empty());
}

TEST(CloseFaces, AreFoundWhereSheetsNearlyTouch) {
  const Icosphere sphere = make_icosphere(3);
  EXPECT_FALSE(Operators(sphere.mesh, pinched(sphere.directions, 0.3)).close.empty());
}

// Compared at the vertices of the coarse mesh, which are the first vertices of the fine one.
TEST(CloseFaces, MakeTheFlowBetweenNearlyTouchingSheetsThatOfAFinerMesh) {
  const Icosphere coarse = make_icosphere(3), fine = make_icosphere(4);
  ASSERT_EQ(fine.directions.leftCols(642), coarse.directions);
  const Operators on_coarse(coarse.mesh, pinched(coarse.directions, 0.3));
  const Operators on_fine(fine.mesh, pinched(fine.directions, 0.3));
  const Points coarse_field = a_strain() * on_coarse.positions, fine_field = a_strain() * on_fine.positions;
  EXPECT_LT(relative_difference(on_coarse.single_layer(coarse_field),
                                on_fine.single_layer(fine_field).leftCols(642)),
            0.02);
  EXPECT_LT(relative_difference(on_coarse.double_layer(coarse_field),
                                on_fine.double_layer(fine_field).leftCols(642)),
            0.05);
}

}  // namespace
}  // namespace capstan
