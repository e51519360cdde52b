#pragma once
// Which faces are too near to a vertex for the vertex rule.
#include <algorithm>
#include <span>
#include <vector>

#include "solver/fluid/stokes/surface.hpp"

namespace capstan {

/// A face seen from one of its corners: (that corner, next, last) counter-clockwise.
struct Corner {
  int face, next, last;
};

/// The faces near one target by the mesh.
struct Rings {
  std::vector<Corner> one_ring;  ///< they touch the target
  std::vector<int> two_ring;  ///< faces that touch one of its neighbours, but not the target; in `near_faces`
  std::vector<int> faces;     ///< both, sorted
  std::vector<int> vertices;  ///< the corners of all of them, the target among them, sorted
};

/// A face that is near a target without the mesh saying so.
struct CloseFace {
  int slot;  ///< of the target, in `targets`
  int face;
};

/// The part of a list in the order of the targets that belongs to one of them.
inline std::span<const CloseFace> close_to(const std::vector<CloseFace>& close, int slot) {
  const auto first = std::ranges::lower_bound(close, slot, {}, &CloseFace::slot);
  const auto last = std::ranges::upper_bound(close, slot, {}, &CloseFace::slot);
  return {first, last};
}

class Neighbourhood {
 public:
  /// \param targets the vertices at which the flow is wanted
  Neighbourhood(const TriangleMesh& mesh, std::vector<int> targets);

  const std::vector<int>& targets() const { return targets_; }
  const std::vector<Rings>& rings() const { return rings_; }          ///< of each target
  const std::vector<int>& near_faces() const { return near_faces_; }  ///< those in the two-ring of any target

  /// Where the surface comes near to itself: folds, dimples whose sheets meet, elements that are drawn out.
  /// The faces outside a target's rings with a corner nearer to it than the longest edge at that corner, in
  /// the order of the targets. On a regular mesh there is none.
  std::vector<CloseFace> close_faces(const Surface& surface) const;

 private:
  Rings rings_around(int target) const;
  void number_near_faces();
  std::vector<int> faces_close_to(int slot, const Surface& surface,
                                  const std::vector<float>& reach_squared) const;

  std::vector<int> targets_;
  std::vector<std::vector<Corner>> corners_;  ///< #V: the faces around each vertex
  Faces faces_;
  std::vector<Rings> rings_;
  std::vector<int> near_faces_;
};

}  // namespace capstan
