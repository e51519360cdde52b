#include "solver/fluid/stokes/neighbourhood.hpp"

#include <algorithm>
#include <set>

namespace capstan {
namespace {

std::vector<std::vector<Corner>> corners_around_vertices(const TriangleMesh& mesh) {
  std::vector<std::vector<Corner>> corners(size_t(mesh.vertex_count()));
  for (int face = 0; face < mesh.faces.cols(); ++face)
    for (int corner : {0, 1, 2})
      corners[mesh.faces(corner, face)].push_back(
          {face, mesh.faces((corner + 1) % 3, face), mesh.faces((corner + 2) % 3, face)});
  return corners;
}

/// The squared length of the longest edge at each vertex. #V, padded with zeros.
std::vector<float> squared_reach(const Surface& surface) {
  std::vector<float> reach(size_t(surface.points.padded_size()), 0.f);
  for (const Edge& edge : surface.mesh.edges) {
    const auto [a, b] = edge.vertices;
    const float length = float((surface.positions.col(a) - surface.positions.col(b)).squaredNorm());
    reach[a] = std::max(reach[a], length);
    reach[b] = std::max(reach[b], length);
  }
  return reach;
}

}  // namespace

Neighbourhood::Neighbourhood(const TriangleMesh& mesh, std::vector<int> targets)
    : targets_(std::move(targets)), corners_(corners_around_vertices(mesh)), faces_(mesh.faces) {
  for (int target : targets_) rings_.push_back(rings_around(target));
  number_near_faces();
}

/// Lists the faces of all two-rings, each once, and replaces face numbers in the rings by indices into this
/// list. Quadrature rules are computed for the faces in the list only. If the targets are a quarter of the
/// vertices, these are less than half of all faces.
void Neighbourhood::number_near_faces() {
  std::vector<int> numbers(size_t(faces_.cols()), -1);
  for (Rings& rings : rings_)
    for (int& face : rings.two_ring) {
      if (numbers[face] < 0) {
        numbers[face] = int(near_faces_.size());
        near_faces_.push_back(face);
      }
      face = numbers[face];
    }
}

Rings Neighbourhood::rings_around(int target) const {
  Rings rings{.one_ring = corners_[target], .two_ring = {}, .faces = {}, .vertices = {}};
  std::set<int> touching, near, vertices;
  for (const Corner& corner : rings.one_ring) {
    touching.insert(corner.face);
    for (const Corner& beyond : corners_[corner.next]) near.insert(beyond.face);
  }
  for (int face : near) {
    if (!touching.contains(face)) rings.two_ring.push_back(face);
    vertices.insert({faces_(0, face), faces_(1, face), faces_(2, face)});
  }
  rings.faces.assign(near.begin(), near.end());
  rings.vertices.assign(vertices.begin(), vertices.end());
  return rings;
}

std::vector<CloseFace> Neighbourhood::close_faces(const Surface& surface) const {
  const std::vector<float> reach_squared = squared_reach(surface);
  std::vector<std::vector<int>> faces(targets_.size());
#pragma omp parallel
  {
    std::vector<unsigned char> within_reach;
#pragma omp for schedule(dynamic, 16)
    for (int slot = 0; slot < int(targets_.size()); ++slot)
      faces[slot] = faces_close_to(slot, surface, reach_squared, within_reach);
  }
  std::vector<CloseFace> close;
  for (int slot = 0; slot < int(targets_.size()); ++slot)
    for (int face : faces[slot]) close.push_back({slot, face});
  return close;
}

/// \param within_reach  scratch
std::vector<int> Neighbourhood::faces_close_to(int slot, const Surface& surface,
                                               const std::vector<float>& reach_squared,
                                               std::vector<unsigned char>& within_reach) const {
  const Rings& rings = rings_[slot];
  const int hits = mark_within_reach(surface.points, reach_squared,
                                     surface.positions.col(targets_[slot]).cast<float>(), within_reach);
  const auto hits_in_rings =
      std::ranges::count_if(rings.vertices, [&](int vertex) { return within_reach[vertex]; });
  if (hits == hits_in_rings) return {};
  std::set<int> faces;
  for (int vertex = 0; vertex < surface.positions.cols(); ++vertex)
    if (within_reach[vertex] && !std::ranges::binary_search(rings.vertices, vertex))
      for (const Corner& corner : corners_[vertex])
        if (!std::ranges::binary_search(rings.faces, corner.face)) faces.insert(corner.face);
  return {faces.begin(), faces.end()};
}

}  // namespace capstan
