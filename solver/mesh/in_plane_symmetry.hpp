#pragma once
// The symmetry of a capsule whose axis lies in the plane of shear. The shear flow (y, 0, 0) is invariant
// under the reflection z -> -z and the rotation by pi about z. A capsule that starts with this symmetry keeps
// it, so a quarter of its vertices determines the others.
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// The orbits of the vertices under the symmetry group: sets of vertices that are images of each other. Each
/// orbit has one representative.
class Orbits {
 public:
  /// The orbits of a surface that has the symmetry exactly, without rounding; else each vertex is an orbit of
  /// its own.
  /// \param positions  3 x #V
  static Orbits of(const Points& positions);
  /// Each vertex is an orbit of its own.
  static Orbits without_symmetry(int vertex_count);

  /// One vertex of each orbit. All lie in one quarter of space, so that they form a connected part of the
  /// surface.
  const std::vector<int>& representatives() const { return representatives_; }
  int vertex_count() const { return int(images_.size()); }
  /// Number of vertices in one orbit: 4, or fewer on the mirror plane and the axis.
  int size(int representative) const { return sizes_[representative]; }

  /// Vectors at all vertices, 3 x #V, from those at the representatives, 3 x #representatives (further
  /// columns are ignored). Components that must vanish by symmetry, at vertices on the mirror plane or the
  /// axis, are set to zero.
  Points extend(const Points& of_representatives) const;
  /// Scalars at all vertices, #V, from those at the representatives.
  Scalars extend_scalars(const Scalars& of_representatives) const;

  /// Vectors at the representatives, 3 x #representatives, from those at all vertices.
  Points restrict(const Points& of_vertices) const { return of_vertices(Eigen::all, representatives_); }

  bool are_trivial() const { return int(representatives_.size()) == vertex_count(); }

 private:
  void count_sizes();

  struct Image {
    int slot;    ///< index of the representative
    Vec3 signs;  ///< of the components of a vector under the symmetry: +-1, or 0 for a component that must
                 ///< vanish
  };
  std::vector<int> representatives_;
  std::vector<Image> images_;  ///< #V
  std::vector<int> sizes_;     ///< #representatives
};

}  // namespace capstan
