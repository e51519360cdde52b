#include "runner/render/membrane_section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace capstan {
namespace {

/// Corners at +-1 on the axes, the first two on x, the next on y, the last on z.
const std::vector<double> kOctahedron = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
const std::vector<int> kFaces = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

std::vector<double> moved_in_z(std::vector<double> positions, double by) {
  for (std::size_t i = 2; i < positions.size(); i += 3) positions[i] += by;
  return positions;
}

double area(const ClosedCurve& curve) {
  double twice = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const PlanePoint a = curve[i], b = curve[(i + 1) % curve.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return std::abs(twice) / 2;
}

TEST(MembraneSection, OfVerticesInThePlaneIsOneCurveThroughThem) {
  const auto section = section_in_plane_of_shear(kOctahedron, kFaces);
  ASSERT_EQ(section.size(), 1u);
  EXPECT_EQ(section[0].size(), 4u);
  EXPECT_DOUBLE_EQ(area(section[0]), 2);
}

TEST(MembraneSection, BetweenVerticesLiesOnTheEdges) {
  for (const double by : {0.25, -0.25}) {
    const auto section = section_in_plane_of_shear(moved_in_z(kOctahedron, by), kFaces);
    ASSERT_EQ(section.size(), 1u);
    EXPECT_DOUBLE_EQ(area(section[0]), 2 * 0.75 * 0.75);
  }
}

TEST(MembraneSection, IsEmptyWhereTheSurfaceDoesNotReachThePlane) {
  EXPECT_TRUE(section_in_plane_of_shear(moved_in_z(kOctahedron, 2), kFaces).empty());
}

TEST(MembraneSection, OfTwoBodiesIsTwoCurves) {
  std::vector<double> positions = kOctahedron;
  std::vector<int> faces = kFaces;
  for (std::size_t i = 0; i < kOctahedron.size(); ++i)
    positions.push_back(kOctahedron[i] + (i % 3 == 0 ? 5 : 0));
  for (const int vertex : kFaces) faces.push_back(vertex + 6);
  EXPECT_EQ(section_in_plane_of_shear(positions, faces).size(), 2u);
}

TEST(MarkerVertex, IsInThePlaneOfShearAtTheTipOfTheMajorAxis) {
  const double s = std::numbers::sqrt2 / 2;
  EXPECT_EQ(marker_vertex(std::vector<double>{-s, -s, 0, 0.1, 0, 0, s, s, 0, 2, 2, 0.5}), 2u);
}

}  // namespace
}  // namespace capstan
