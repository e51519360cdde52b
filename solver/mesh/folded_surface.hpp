#pragma once
// Curvature of a polyhedral surface: faces are flat, the curvature is concentrated at their edges.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct FoldedSurface {
  FoldedSurface(const TriangleMesh& mesh, const Points& positions);

  Points normals;        ///< 3 x #F, unit, outward
  Scalars face_areas;    ///< #F
  Scalars vertex_areas;  ///< #V: A_i, a third of the areas of the faces around i
  Scalars lengths;       ///< #E: l
  Scalars angles;        ///< #E: theta between the normals of the two faces, > 0 at convex edges

  /// #V: 2H_i = 1/A_i sum_edges l theta / 2, after Jülicher (J. Phys. II 6, 1797, 1996). Positive on a
  /// sphere. Its integrals converge as the mesh is refined. Its values at single vertices are inaccurate
  /// where the faces are irregular.
  Scalars total_curvatures;
};

}  // namespace capstan
