#pragma once
// The capsule's surface at one instant, as the boundary integrals need it: flat triangles, and the vertex
// rule, a quadrature rule in which a third of the area of each triangle belongs to each of its corners.
#include "solver/fluid/stokes/point_sums.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct Surface {
  Surface(const TriangleMesh& mesh, const Points& positions);

  const TriangleMesh& mesh;
  const Points& positions;     ///< 3 x #V
  Points face_area_vectors;    ///< 3 x #F: outward normal times area
  Scalars face_areas;          ///< #F
  Points vertex_area_vectors;  ///< 3 x #V: N_i = dVolume/dx_i, a third of the sum over the faces around the
                               ///< vertex
  Scalars vertex_areas;        ///< #V: A_i, likewise
  PointArray points;           ///< the positions in single precision
};

}  // namespace capstan
