#pragma once
// A part of a triangulated surface: some vertices and a number of rings of faces around them.
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct SurfacePatch {
  std::vector<int> vertices;  ///< index in the whole surface of each vertex of the patch
  /// Faces of the patch, edges between two of them, and one-rings. Vertices that have faces outside the patch
  /// have empty one-rings.
  TriangleMesh mesh;

  /// Vectors at the vertices of the patch, 3 x #vertices, from those of the whole surface, 3 x #V.
  Points restrict(const Points& of_whole) const { return of_whole(Eigen::all, vertices); }
};

/// The patch of all faces around `centres` and, for each further ring, of all faces around the vertices that
/// the patch has so far. The centres are its first vertices, in the given order.
SurfacePatch patch_around(const std::vector<int>& centres, int rings, const TriangleMesh& whole);

}  // namespace capstan
