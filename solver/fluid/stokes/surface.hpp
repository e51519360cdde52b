#pragma once
// The capsule's surface as the boundary integrals see it at one instant: flat triangles and the vertex rule,
// in which a third of each triangle belongs to each of its corners.
#include "solver/fluid/stokes/point_sums.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct Surface {
  Surface(const TriangleMesh& mesh, const Points& positions);

  const TriangleMesh& mesh;
  const Points& positions;     ///< 3 x #V
  Points face_area_vectors;    ///< 3 x #F
  Scalars face_areas;          ///< #F
  Points vertex_area_vectors;  ///< 3 x #V: N_i, the gradient of the volume
  Scalars vertex_areas;        ///< #V: A_i
  PointArray points;           ///< the positions for the sums over pairs
};

}  // namespace capstan
