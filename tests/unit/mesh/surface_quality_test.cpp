#include "solver/mesh/surface_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/mesh/icosphere.hpp"

namespace capstan {
namespace {

SurfaceQuality quality_of(const Icosphere& sphere, const Points& positions) {
  return surface_quality(sphere.mesh, positions);
}

// The faces of an icosahedron meet at arccos(-sqrt(5)/3), so their normals at 41.81 degrees.
TEST(SurfaceQuality, OfAnIcosahedronIsExact) {
  const Icosphere sphere = make_icosphere(0);
  const SurfaceQuality quality = quality_of(sphere, sphere.directions);
  EXPECT_NEAR(quality.largest_dihedral, 180 - std::acos(-std::sqrt(5.) / 3) * 180 / std::numbers::pi, 1e-6);
  EXPECT_NEAR(quality.smallest_angle, 60, 1e-6);
  EXPECT_EQ(quality.folded_edges, 0);
  EXPECT_NEAR(quality.longest_edge, 4 / std::sqrt(10 + 2 * std::sqrt(5.)), 1e-6);  // of circumradius 1
}

TEST(SurfaceQuality, ADrawnOutMeshShowsLongerWavesOnly) {
  const Icosphere sphere = make_icosphere(3);
  const Points drawn_out = Vec3(3, 1, 1).asDiagonal() * sphere.directions;
  const double round = smallest_wavelength(quality_of(sphere, sphere.directions));
  EXPECT_GT(round, 0.25);
  EXPECT_LT(round, 0.35);
  EXPECT_NEAR(smallest_wavelength(quality_of(sphere, drawn_out)) / round, 3, 0.3);
}

TEST(SurfaceQuality, DihedralAngleOfASphereHalvesWithTheEdges) {
  const Icosphere coarse = make_icosphere(3), fine = make_icosphere(4);
  const double angle = quality_of(coarse, coarse.directions).largest_dihedral;
  EXPECT_LT(angle, 12);
  EXPECT_NEAR(quality_of(fine, fine.directions).largest_dihedral, angle / 2, 0.02 * angle);
}

TEST(SurfaceQuality, SeesAVertexThatIsPushedThroughTheSurface) {
  const Icosphere sphere = make_icosphere(3);
  Points dented = sphere.directions;
  dented.col(100) *= 0.7;
  const SurfaceQuality quality = quality_of(sphere, dented);
  EXPECT_GT(quality.largest_dihedral, kFoldedEdge);
  EXPECT_NEAR(quality.folded_edges * double(sphere.mesh.edges.size()), 6, 3);  // those around it
  EXPECT_LT(quality.smallest_angle, 40);
}

TEST(SurfaceQuality, OfACollapsedTriangleIsANumber) {
  const Icosphere sphere = make_icosphere(1);
  Points collapsed = sphere.directions;
  collapsed.col(0) = collapsed.col(sphere.mesh.one_ring[0][0]);
  const SurfaceQuality quality = quality_of(sphere, collapsed);
  EXPECT_NEAR(quality.smallest_angle, 0, 1e-6);
  EXPECT_GE(quality.largest_dihedral, 90);
}

TEST(SurfaceQuality, DoesNotDependOnSizeAndPlace) {
  const Icosphere sphere = make_icosphere(2);
  const Points ellipsoid = Vec3(2, 1, 0.7).asDiagonal() * sphere.directions;
  const Points elsewhere = (1e-3 * ellipsoid).colwise() + Vec3(5, 0, 0);
  EXPECT_NEAR(quality_of(sphere, ellipsoid).largest_dihedral, quality_of(sphere, elsewhere).largest_dihedral,
              1e-8);
  EXPECT_NEAR(quality_of(sphere, ellipsoid).smallest_angle, quality_of(sphere, elsewhere).smallest_angle,
              1e-8);
}

TEST(SurfaceQuality, WorstOfTwoTakesTheWorseOfEach) {
  const SurfaceQuality worst = worst_of({20, 0.1, 50, 0.4}, {70, 0, 30, 0.2});
  EXPECT_EQ(worst, (SurfaceQuality{70, 0.1, 30, 0.4}));
}

}  // namespace
}  // namespace capstan
