#include "solver/mesh/icosphere.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace capstan {
namespace {

struct Triangulation {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> faces;
};

/// (0, +-1, +-phi) and the cyclic permutations. In this orientation the coordinate planes are mirror planes.
std::vector<Vec3> icosahedron_vertices() {
  std::vector<Vec3> vertices;
  for (double s : {1.0, -1.0})
    for (double t : {std::numbers::phi, -std::numbers::phi}) {
      vertices.emplace_back(0, s, t);
      vertices.emplace_back(s, t, 0);
      vertices.emplace_back(t, 0, s);
    }
  return vertices;
}

/// The faces are all triples of vertices with distances of one edge length, 2, from each other. They are
/// oriented outwards.
Triangulation icosahedron() {
  Triangulation result{icosahedron_vertices(), {}};
  std::vector<Vec3>& x = result.vertices;
  const auto joined = [&](int i, int j) { return (x[i] - x[j]).norm() < 2.1; };  // the next distance is 2 phi
  for (int i = 0; i < 12; ++i)
    for (int j = i + 1; j < 12; ++j)
      for (int k = j + 1; k < 12; ++k) {
        if (!joined(i, j) || !joined(j, k) || !joined(k, i)) continue;
        if (x[i].dot(x[j].cross(x[k])) > 0)
          result.faces.push_back({i, j, k});
        else
          result.faces.push_back({i, k, j});
      }
  for (Vec3& vertex : x) vertex.normalize();
  return result;
}

/// Splits every face into four at the midpoints of its edges, which are projected onto the sphere. The
/// floating-point sum of two numbers is commutative and odd, so the reflections stay exact.
Triangulation subdivided(Triangulation coarse) {
  Triangulation fine{std::move(coarse.vertices), {}};
  std::map<std::pair<int, int>, int> midpoints;
  const auto midpoint = [&](int i, int j) {
    const auto [entry, is_new] =
        midpoints.try_emplace(std::minmax(i, j), static_cast<int>(fine.vertices.size()));
    if (is_new) fine.vertices.push_back((fine.vertices[i] + fine.vertices[j]).normalized());
    return entry->second;
  };
  for (const auto& [i, j, k] : coarse.faces) {
    const int ij = midpoint(i, j), jk = midpoint(j, k), ki = midpoint(k, i);
    fine.faces.insert(fine.faces.end(), {{i, ij, ki}, {ij, j, jk}, {ki, jk, k}, {ij, jk, ki}});
  }
  return fine;
}

}  // namespace

Icosphere make_icosphere(int subdivisions) {
  Triangulation sphere = icosahedron();
  for (int level = 0; level < subdivisions; ++level) sphere = subdivided(std::move(sphere));
  const int vertex_count = static_cast<int>(sphere.vertices.size());
  const int face_count = static_cast<int>(sphere.faces.size());
  const Points directions = Points::Map(sphere.vertices.front().data(), 3, vertex_count);
  const Faces faces = Faces::Map(sphere.faces.front().data(), 3, face_count);
  return {directions, make_mesh(faces, vertex_count)};
}

}  // namespace capstan
