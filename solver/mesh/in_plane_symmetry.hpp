#pragma once
// The symmetry of a capsule that starts in the plane of shear. The flow (y, 0, 0) is unchanged by the mirror
// z -> -z and by the half-turn about z, and so is the capsule for ever: a quarter of its vertices knows all.
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// The vertices in groups whose members are images of each other; one of each group stands for all.
class Orbits {
 public:
  /// The groups of a surface that has the symmetry to the last bit; of any other surface each vertex is its
  /// own. \param positions 3 x #V
  static Orbits of(const Points& positions);
  /// No symmetry: every vertex stands for itself.
  static Orbits without_symmetry(int vertex_count);

  /// All in one quarter of space, so that they are neighbours of each other.
  const std::vector<int>& representatives() const { return representatives_; }
  int vertex_count() const { return int(images_.size()); }
  /// Vertices of one group: 4, or fewer on the mirror or the axis.
  int size(int representative) const { return sizes_[representative]; }

  /// 3 x #representatives, or more columns behind theirs, to 3 x #V: vectors of the representatives turned
  /// onto their images. What a vertex on the mirror or the axis cannot have (a velocity out of the plane) is
  /// set to zero.
  Points extend(const Points& of_representatives) const;
  /// Likewise to #V: numbers that are the same in images.
  Scalars extend_scalars(const Scalars& of_representatives) const;

  /// 3 x #V to 3 x #representatives.
  Points restrict(const Points& of_vertices) const { return of_vertices(Eigen::all, representatives_); }

  bool are_trivial() const { return int(representatives_.size()) == vertex_count(); }

 private:
  void count_sizes();

  struct Image {
    int slot;    ///< which representative
    Vec3 signs;  ///< +-1 a component, 0 where the vertex is its own image with the other sign
  };
  std::vector<int> representatives_;
  std::vector<Image> images_;  ///< of each vertex
  std::vector<int> sizes_;     ///< of each group
};

}  // namespace capstan
