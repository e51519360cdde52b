#include "solver/mesh/surface_patch.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"

namespace capstan {
namespace {

TEST(SurfacePatch, AroundAllVerticesIsTheSurface) {
  const TriangleMesh whole = make_icosphere(2).mesh;
  std::vector<int> all(std::size_t(whole.vertex_count()));
  std::iota(all.begin(), all.end(), 0);
  const SurfacePatch patch = patch_around(all, 1, whole);
  EXPECT_EQ(patch.vertices, all);
  EXPECT_EQ(patch.mesh.faces, whole.faces);
  EXPECT_EQ(patch.mesh.one_ring, whole.one_ring);
  EXPECT_EQ(patch.mesh.edges.size(), whole.edges.size());
}

TEST(SurfacePatch, OfOneRingHasTheFacesAroundItsCentreAndTheEdgesBetweenThem) {
  const Icosphere sphere = make_icosphere(2);
  const int centre = 100;
  const SurfacePatch patch = patch_around({centre}, 1, sphere.mesh);
  const std::size_t neighbours = sphere.mesh.one_ring[centre].size();
  EXPECT_EQ(patch.vertices.size(), 1 + neighbours);
  EXPECT_EQ(patch.mesh.faces.cols(), Eigen::Index(neighbours));
  EXPECT_EQ(patch.mesh.edges.size(), neighbours);
  for (const Edge& edge : patch.mesh.edges) EXPECT_EQ(std::min(edge.vertices[0], edge.vertices[1]), 0);
  EXPECT_EQ(patch.mesh.one_ring[0].size(), neighbours);
}

TEST(SurfacePatch, OfTwoRingsHasAllFacesOfTheNeighboursOfItsCentre) {
  const Icosphere sphere = make_icosphere(3);
  const int centre = 300;
  const SurfacePatch patch = patch_around({centre}, 2, sphere.mesh);
  const Scalars of_patch = vertex_areas(patch.restrict(sphere.directions), patch.mesh.faces);
  const Scalars of_whole = vertex_areas(sphere.directions, sphere.mesh.faces);
  const std::size_t inside = 1 + sphere.mesh.one_ring[centre].size();
  for (std::size_t vertex = 0; vertex < inside; ++vertex) {
    EXPECT_DOUBLE_EQ(of_patch[Eigen::Index(vertex)], of_whole[patch.vertices[vertex]]);
    EXPECT_EQ(patch.mesh.one_ring[vertex].size(), sphere.mesh.one_ring[patch.vertices[vertex]].size());
  }
}

}  // namespace
}  // namespace capstan
