#include "solver/mesh/in_plane_symmetry.hpp"

#include <gtest/gtest.h>

#include "solver/mesh/shapes.hpp"

namespace capstan {
namespace {

Points red_blood_cell(const Icosphere& sphere) {
  Case c;
  c.shape = Shape::biconcave;
  return initial_positions(c, sphere);
}

TEST(InPlaneSymmetry, AQuarterOfTheVerticesStandsForAllOfAnInclinedCell) {
  const Icosphere sphere = make_icosphere(3);
  const Orbits orbits = Orbits::of(red_blood_cell(sphere));
  EXPECT_EQ(orbits.vertex_count(), 642);
  EXPECT_LT(orbits.representatives().size(),
            642 / 4 + 40);  // those on the mirror and on the axis have fewer images
}

TEST(InPlaneSymmetry, RepresentativesStandInOneQuarter) {
  const Points positions = red_blood_cell(make_icosphere(3));
  const Points of_representatives = Orbits::of(positions).restrict(positions);
  EXPECT_GE(of_representatives.row(1).minCoeff(), 0);
  EXPECT_GE(of_representatives.row(2).minCoeff(), 0);
}

TEST(InPlaneSymmetry, ExtendingTheRepresentativesGivesTheWholeSurfaceToTheLastBit) {
  const Icosphere sphere = make_icosphere(2);
  const Points positions = red_blood_cell(sphere);
  const Orbits orbits = Orbits::of(positions);
  EXPECT_EQ(orbits.extend(orbits.restrict(positions)), positions);
}

TEST(InPlaneSymmetry, NothingLeavesTheMirrorOrTheAxis) {
  const Points positions = make_icosphere(2).directions;
  const Orbits orbits = Orbits::of(positions);
  const Points vectors = orbits.extend(Points::Ones(3, Eigen::Index(orbits.representatives().size())));
  for (Eigen::Index vertex = 0; vertex < positions.cols(); ++vertex) {
    const Vec3 x = positions.col(vertex), u = vectors.col(vertex);
    if (x.z() == 0) {
      EXPECT_EQ(u.z(), 0);
    }
    if (x.x() == 0 && x.y() == 0) {
      EXPECT_EQ(u.head<2>().norm(), 0);
    }
  }
}

TEST(InPlaneSymmetry, ASurfaceWithoutItHasNoImages) {
  Points positions = make_icosphere(2).directions;
  positions(2, 17) += 1e-15;
  EXPECT_EQ(Orbits::of(positions).representatives().size(), 162u);
}

}  // namespace
}  // namespace capstan
