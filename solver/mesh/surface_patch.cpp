#include "solver/mesh/surface_patch.hpp"

#include <algorithm>

namespace capstan {
namespace {

constexpr int kNone = -1;

/// Numbers the vertices of the patch from 0, in the order in which they are added.
class Places {
 public:
  explicit Places(int vertex_count) : places_(std::size_t(vertex_count), kNone) {}

  void add(int vertex) {
    if (places_[vertex] != kNone) return;
    places_[vertex] = int(vertices_.size());
    vertices_.push_back(vertex);
  }
  int of(int vertex) const { return places_[vertex]; }
  const std::vector<int>& vertices() const { return vertices_; }

 private:
  std::vector<int> places_, vertices_;
};

void add_neighbours(const TriangleMesh& whole, Places& places) {
  const std::vector<int> met = places.vertices();
  for (int vertex : met)
    for (int neighbour : whole.one_ring[vertex]) places.add(neighbour);
}

}  // namespace

SurfacePatch patch_around(const std::vector<int>& centres, int rings, const TriangleMesh& whole) {
  Places places(whole.vertex_count());
  for (int centre : centres) places.add(centre);
  for (int ring = 1; ring < rings; ++ring) add_neighbours(whole, places);
  const int complete = int(places.vertices().size());  // vertices before it have all their faces in the patch
  add_neighbours(whole, places);

  SurfacePatch patch{places.vertices(), {}};
  const auto is_complete = [&](int vertex) {
    return places.of(vertex) != kNone && places.of(vertex) < complete;
  };
  std::vector<int> faces, face_places(std::size_t(whole.faces.cols()), kNone);
  for (int face = 0; face < whole.faces.cols(); ++face)
    if (std::ranges::any_of(whole.faces.col(face), is_complete)) {
      face_places[face] = int(faces.size());
      faces.push_back(face);
    }
  const auto place = [&](int vertex) { return places.of(vertex); };
  patch.mesh.faces = whole.faces(Eigen::all, faces).unaryExpr(place);
  for (const Edge& edge : whole.edges) {
    const std::array<int, 2> both = {face_places[edge.faces[0]], face_places[edge.faces[1]]};
    if (both[0] == kNone || both[1] == kNone) continue;
    patch.mesh.edges.push_back({{place(edge.vertices[0]), place(edge.vertices[1])},
                                {place(edge.opposite[0]), place(edge.opposite[1])},
                                both});
  }
  patch.mesh.one_ring.resize(patch.vertices.size());
  for (int vertex = 0; vertex < complete; ++vertex)
    for (int neighbour : whole.one_ring[patch.vertices[vertex]])
      patch.mesh.one_ring[vertex].push_back(place(neighbour));
  return patch;
}

}  // namespace capstan
