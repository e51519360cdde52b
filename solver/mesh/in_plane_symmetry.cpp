#include "solver/mesh/in_plane_symmetry.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace capstan {
namespace {

using Key = std::array<double, 3>;
Key key(const Vec3& x) { return {x[0], x[1], x[2]}; }

/// Signs of (x, y, z) under the reflection z -> -z, the rotation by pi about z, and both.
const std::array<Vec3, 3> kSymmetries = {Vec3(1, 1, -1), Vec3(-1, -1, 1), Vec3(-1, -1, -1)};

/// A quarter of space that has exactly one point of each orbit.
bool is_in_quarter(const Vec3& x) { return x.z() >= 0 && (x.y() > 0 || (x.y() == 0 && x.x() >= 0)); }

std::map<Key, int> vertices_by_position(const Points& positions) {
  std::map<Key, int> vertices;
  for (int vertex = 0; vertex < positions.cols(); ++vertex) vertices[key(positions.col(vertex))] = vertex;
  return vertices;
}

}  // namespace

Orbits Orbits::of(const Points& positions) {
  const std::map<Key, int> vertices = vertices_by_position(positions);
  Orbits orbits;
  orbits.images_.assign(size_t(positions.cols()), {-1, Vec3::Ones()});
  for (int vertex = 0; vertex < positions.cols(); ++vertex) {
    if (orbits.images_[vertex].slot >= 0 || !is_in_quarter(positions.col(vertex))) continue;
    const int slot = int(orbits.representatives_.size());
    orbits.representatives_.push_back(vertex);
    orbits.images_[vertex].slot = slot;
    for (const Vec3& signs : kSymmetries) {
      const auto found = vertices.find(key(signs.cwiseProduct(positions.col(vertex))));
      if (found == vertices.end()) return without_symmetry(int(positions.cols()));
      Image& image = orbits.images_[found->second];
      if (image.slot < 0)
        image = {slot, signs};
      else
        image.signs = 0.5 * (image.signs + signs);  // on the mirror plane or axis: opposite signs give 0
    }
  }
  const auto is_alone = [](const Image& image) { return image.slot < 0; };
  if (std::ranges::any_of(orbits.images_, is_alone)) return without_symmetry(int(positions.cols()));
  orbits.count_sizes();
  return orbits;
}

void Orbits::count_sizes() {
  sizes_.assign(representatives_.size(), 0);
  for (const Image& image : images_) ++sizes_[image.slot];
}

Orbits Orbits::without_symmetry(int vertex_count) {
  Orbits orbits;
  for (int vertex = 0; vertex < vertex_count; ++vertex) {
    orbits.representatives_.push_back(vertex);
    orbits.images_.push_back({vertex, Vec3::Ones()});
  }
  orbits.count_sizes();
  return orbits;
}

Points Orbits::extend(const Points& of_representatives) const {
  Points of_vertices(3, vertex_count());
  for (int vertex = 0; vertex < vertex_count(); ++vertex)
    of_vertices.col(vertex) =
        images_[vertex].signs.cwiseProduct(of_representatives.col(images_[vertex].slot));
  return of_vertices;
}

Scalars Orbits::extend_scalars(const Scalars& of_representatives) const {
  Scalars of_vertices(vertex_count());
  for (int vertex = 0; vertex < vertex_count(); ++vertex)
    of_vertices[vertex] = of_representatives[images_[vertex].slot];
  return of_vertices;
}

}  // namespace capstan
