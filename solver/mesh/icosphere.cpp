#include "solver/mesh/icosphere.hpp"

#include <algorithm>
#include <array>
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

/// The sum of three numbers, the smallest first: so it does not depend on the order of the vertices of a
/// face, and the reflections stay exact.
double ordered_sum(double a, double b, double c) {
  std::array<double, 3> terms = {a, b, c};
  std::ranges::sort(terms, {}, [](double term) { return std::abs(term); });
  return terms[0] + terms[1] + terms[2];
}

Vec3 centre(const Vec3& a, const Vec3& b, const Vec3& c) {
  return Vec3(ordered_sum(a.x(), b.x(), c.x()), ordered_sum(a.y(), b.y(), c.y()),
              ordered_sum(a.z(), b.z(), c.z()))
      .normalized();
}

/// Splits every face of the icosahedron into nine: at the thirds of its edges, and at its centre.
Triangulation divided_by_three(Triangulation coarse) {
  Triangulation fine{std::move(coarse.vertices), {}};
  std::map<std::pair<int, int>, int> thirds;
  const auto third = [&](int near, int far) {
    const auto [entry, is_new] = thirds.try_emplace({near, far}, static_cast<int>(fine.vertices.size()));
    if (is_new) fine.vertices.push_back((2 * fine.vertices[near] + fine.vertices[far]).normalized());
    return entry->second;
  };
  for (const auto& [i, j, k] : coarse.faces) {
    const int ij = third(i, j), ji = third(j, i), jk = third(j, k), kj = third(k, j), ki = third(k, i),
              ik = third(i, k);
    const int m = static_cast<int>(fine.vertices.size());
    fine.vertices.push_back(centre(fine.vertices[i], fine.vertices[j], fine.vertices[k]));
    fine.faces.insert(fine.faces.end(), {{i, ij, ik},
                                         {ij, ji, m},
                                         {ji, j, jk},
                                         {ji, jk, m},
                                         {jk, kj, m},
                                         {kj, k, ki},
                                         {kj, ki, m},
                                         {ki, ik, m},
                                         {ik, ij, m}});
  }
  return fine;
}

Icosphere subdivided(Triangulation sphere, int times) {
  for (int level = 0; level < times; ++level) sphere = subdivided(std::move(sphere));
  const int vertex_count = static_cast<int>(sphere.vertices.size());
  const int face_count = static_cast<int>(sphere.faces.size());
  const Points directions = Points::Map(sphere.vertices.front().data(), 3, vertex_count);
  const Faces faces = Faces::Map(sphere.faces.front().data(), 3, face_count);
  return {directions, make_mesh(faces, vertex_count)};
}

}  // namespace

Icosphere make_icosphere(int subdivisions) { return subdivided(icosahedron(), subdivisions); }

Icosphere icosphere_with(int nodes) {
  const int parts = int(std::lround(std::sqrt((nodes - 2) / 10.)));  // of an edge of the icosahedron
  const bool by_three = parts % 3 == 0;
  return subdivided(by_three ? divided_by_three(icosahedron()) : icosahedron(),
                    int(std::lround(std::log2(by_three ? parts / 3 : parts))));
}

}  // namespace capstan
