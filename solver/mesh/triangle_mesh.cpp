#include "solver/mesh/triangle_mesh.hpp"

#include <cassert>
#include <cstdint>
#include <unordered_map>

namespace capstan {
namespace {

/// A side of a face: the face and its corner opposite to the side.
struct Side {
  int opposite;
  int face;
};

/// Every directed side (from, to) of a closed oriented mesh belongs to exactly one face.
class Sides {
 public:
  explicit Sides(const Faces& faces) {
    sides_.reserve(3 * faces.cols());
    for (int face = 0; face < faces.cols(); ++face)
      for (int corner = 0; corner < 3; ++corner)
        sides_[key(faces(corner, face), faces((corner + 1) % 3, face))] = {faces((corner + 2) % 3, face),
                                                                           face};
    assert(static_cast<Eigen::Index>(sides_.size()) == 3 * faces.cols());
  }

  const Side& between(int from, int to) const { return sides_.at(key(from, to)); }

 private:
  static std::uint64_t key(int from, int to) {
    return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint64_t>(to);
  }
  std::unordered_map<std::uint64_t, Side> sides_;
};

std::vector<Edge> edges_of(const Faces& faces, const Sides& sides) {
  std::vector<Edge> edges;
  for (int face = 0; face < faces.cols(); ++face)
    for (int corner = 0; corner < 3; ++corner) {
      const int from = faces(corner, face), to = faces((corner + 1) % 3, face);
      if (from > to) continue;  // the face on the other side adds this edge
      const Side& other = sides.between(to, from);
      edges.push_back({{from, to}, {faces((corner + 2) % 3, face), other.opposite}, {face, other.face}});
    }
  return edges;
}

/// Neighbours of the vertex, counter-clockwise: in a counter-clockwise face (vertex, neighbour, next) the
/// vertex `next` follows `neighbour`.
std::vector<int> ring_around(int vertex, int first, const Sides& sides) {
  std::vector<int> ring{first};
  for (int next = sides.between(vertex, first).opposite; next != first;
       next = sides.between(vertex, next).opposite)
    ring.push_back(next);
  return ring;
}

}  // namespace

TriangleMesh make_mesh(const Faces& faces, int vertex_count) {
  const Sides sides(faces);
  TriangleMesh mesh{faces, edges_of(faces, sides), {}};
  mesh.one_ring.resize(static_cast<size_t>(vertex_count));
  for (const Edge& edge : mesh.edges)
    for (int end : {0, 1}) {
      std::vector<int>& ring = mesh.one_ring[edge.vertices[end]];
      if (ring.empty()) ring = ring_around(edge.vertices[end], edge.vertices[1 - end], sides);
    }
  return mesh;
}

}  // namespace capstan
