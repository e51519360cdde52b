#include "solver/mesh/icosphere.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace capstan {
namespace {

using Coordinates = std::tuple<double, double, double>;
using Corners = std::set<int>;

Coordinates coordinates(const Vec3& x) { return {x[0] + 0.0, x[1] + 0.0, x[2] + 0.0}; }  // -0 becomes 0

/// The vertex that lies, to the last bit, where the reflection puts each vertex; throws if there is none.
std::vector<int> images(const Points& positions, const Vec3& signs) {
  std::map<Coordinates, int> at;
  for (int i = 0; i < positions.cols(); ++i) at[coordinates(positions.col(i))] = i;
  std::vector<int> image;
  for (const auto& x : positions.colwise()) image.push_back(at.at(coordinates(x.cwiseProduct(signs))));
  return image;
}

std::set<Corners> face_set(const Faces& faces, const std::vector<int>& renamed) {
  std::set<Corners> set;
  for (const auto& face : faces.colwise()) set.insert({renamed[face[0]], renamed[face[1]], renamed[face[2]]});
  return set;
}

TEST(Icosphere, HasTenTimesFourToTheNPlusTwoVertices) {
  for (int n = 0, expected = 12; n <= 4; ++n, expected = 4 * expected - 6)
    EXPECT_EQ(make_icosphere(n).mesh.vertex_count(), expected);
}

TEST(Icosphere, WithEachNumberOfNodesHasThatNumberAndExactReflections) {
  for (const int nodes : {12, 42, 92, 162, 362, 642, 1442}) {
    const Icosphere sphere = icosphere_with(nodes);
    ASSERT_EQ(sphere.mesh.vertex_count(), nodes);
    std::vector<int> same(nodes);
    std::iota(same.begin(), same.end(), 0);
    for (const Vec3& signs : {Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)}) {
      const std::vector<int> image = images(sphere.directions, signs);
      EXPECT_EQ(face_set(sphere.mesh.faces, image), face_set(sphere.mesh.faces, same)) << nodes << " nodes";
    }
  }
}

TEST(Icosphere, IsAClosedSphereByEulersFormula) {
  const Icosphere sphere = make_icosphere(3);
  const int vertices = sphere.mesh.vertex_count();
  const int edges = static_cast<int>(sphere.mesh.edges.size());
  const int faces = static_cast<int>(sphere.mesh.faces.cols());
  EXPECT_EQ(vertices - edges + faces, 2);
}

TEST(Icosphere, TwelveVerticesHaveFiveNeighboursAllOthersSix) {
  const Icosphere sphere = make_icosphere(3);
  const auto fives = std::ranges::count_if(sphere.mesh.one_ring,
                                           [](const std::vector<int>& ring) { return ring.size() == 5; });
  const auto sixes = std::ranges::count_if(sphere.mesh.one_ring,
                                           [](const std::vector<int>& ring) { return ring.size() == 6; });
  EXPECT_EQ(fives, 12);
  EXPECT_EQ(sixes, sphere.mesh.vertex_count() - 12);
}

TEST(Icosphere, FacesTurnCounterClockwiseSeenFromOutside) {
  const Icosphere sphere = make_icosphere(2);
  const Points& x = sphere.directions;
  for (const auto& f : sphere.mesh.faces.colwise())
    EXPECT_GT(x.col(f[0]).dot(Vec3(x.col(f[1])).cross(Vec3(x.col(f[2])))), 0);
}

TEST(Icosphere, OneRingsRunCounterClockwiseAlongEdges) {
  const Icosphere sphere = make_icosphere(2);
  const Points& x = sphere.directions;
  for (int vertex = 0; vertex < sphere.mesh.vertex_count(); ++vertex) {
    const std::vector<int>& ring = sphere.mesh.one_ring[vertex];
    for (size_t j = 0; j < ring.size(); ++j) {
      const int next = ring[(j + 1) % ring.size()];
      const Vec3 a = x.col(ring[j]), b = x.col(next);
      EXPECT_GT(x.col(vertex).dot(a.cross(b)), 0);
      EXPECT_TRUE(std::ranges::count(sphere.mesh.one_ring[ring[j]], next));
    }
  }
}

TEST(Icosphere, EdgesKnowTheirFacesAndTheCornersOpposite) {
  const TriangleMesh mesh = make_icosphere(1).mesh;
  for (const Edge& edge : mesh.edges)
    for (int side : {0, 1}) {
      const int from = edge.vertices[side], to = edge.vertices[1 - side];
      const auto face = mesh.faces.col(edge.faces[side]);
      const int corner = static_cast<int>(std::ranges::find(face, from) - face.begin());
      EXPECT_EQ(face[(corner + 1) % 3], to);
      EXPECT_EQ(face[(corner + 2) % 3], edge.opposite[side]);
    }
}

TEST(Icosphere, TheSymmetriesOfTheShearPlaneMapItOntoItselfWithoutRounding) {
  const Icosphere sphere = make_icosphere(4);
  std::vector<int> itself(static_cast<size_t>(sphere.mesh.vertex_count()));
  for (size_t i = 0; i < itself.size(); ++i) itself[i] = static_cast<int>(i);
  const std::set<Corners> faces = face_set(sphere.mesh.faces, itself);
  for (const Vec3& signs : {Vec3(1, 1, -1), Vec3(-1, -1, 1)})
    EXPECT_EQ(face_set(sphere.mesh.faces, images(sphere.directions, signs)), faces);
}

}  // namespace
}  // namespace capstan
