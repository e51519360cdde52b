#pragma once
// The faces so near to a target vertex that the vertex rule (surface.hpp) is not accurate on them.
#include <algorithm>
#include <span>
#include <vector>

#include "solver/fluid/stokes/surface.hpp"

namespace capstan {

/// A face at one of its corners. The corners (this one, next, last) are in counter-clockwise order.
struct Corner {
  int face;
  int next, last;  ///< vertices
};

/// The faces near a target vertex in the topology of the mesh.
struct Rings {
  std::vector<Corner> one_ring;  ///< faces that touch the target
  std::vector<int> two_ring;  ///< other faces that touch a neighbour of the target: indices into near_faces()
  std::vector<int> faces;     ///< both, sorted
  std::vector<int> vertices;  ///< corners of all these faces, the target included, sorted
};

/// A face that is near a target in space, but not in the topology of the mesh.
struct CloseFace {
  int slot;  ///< of the target: index into targets()
  int face;
};

/// The faces that are close to one target.
/// \param close  sorted by target
inline std::span<const CloseFace> close_to(const std::vector<CloseFace>& close, int slot) {
  const auto first = std::ranges::lower_bound(close, slot, {}, &CloseFace::slot);
  const auto last = std::ranges::upper_bound(close, slot, {}, &CloseFace::slot);
  return {first, last};
}

class Neighbourhood {
 public:
  /// \param targets  the vertices at which velocities are computed
  Neighbourhood(const TriangleMesh& mesh, std::vector<int> targets);

  const std::vector<int>& targets() const { return targets_; }
  /// Rings of each target.
  const std::vector<Rings>& rings() const { return rings_; }
  /// The faces in the two-ring of any target.
  const std::vector<int>& near_faces() const { return near_faces_; }

  /// Faces where the surface comes near to itself: folds, dimples whose sheets meet, elongated elements.
  /// These are the faces outside of a target's rings with a corner that is nearer to the target than the
  /// longest edge at that corner. Sorted by target; empty on a regular mesh.
  std::vector<CloseFace> close_faces(const Surface& surface) const;

 private:
  Rings rings_around(int target) const;
  void number_near_faces();
  std::vector<int> faces_close_to(int slot, const Surface& surface, const std::vector<float>& reach_squared,
                                  std::vector<unsigned char>& within_reach) const;

  std::vector<int> targets_;
  std::vector<std::vector<Corner>> corners_;  ///< #V: corners of the faces around each vertex
  Faces faces_;
  std::vector<Rings> rings_;
  std::vector<int> near_faces_;
};

}  // namespace capstan
