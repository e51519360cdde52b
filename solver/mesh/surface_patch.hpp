#pragma once
// A part of a triangulated surface: some vertices with all that stands around them.
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct SurfacePatch {
  std::vector<int> vertices;  ///< of the whole surface, in the order of the patch's own
  /// Edges inside the patch, and the one-rings of the vertices that have all their faces in it; empty ones of
  /// the others.
  TriangleMesh mesh;

  /// 3 x #V of the whole surface to 3 x #vertices.
  Points restrict(const Points& of_whole) const { return of_whole(Eigen::all, vertices); }
};

/// The faces around `centres` and, for each further ring, those around the vertices met so far. The centres
/// come first, in their order.
SurfacePatch patch_around(const std::vector<int>& centres, int rings, const TriangleMesh& whole);

}  // namespace capstan
