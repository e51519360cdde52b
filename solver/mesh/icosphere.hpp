#pragma once
// A nearly uniform triangulation of the unit sphere: an icosahedron, its faces split into four again and
// again.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct Icosphere {
  Points directions;  ///< 3 x #V, unit vectors
  TriangleMesh mesh;
};

/// 10 * 4^subdivisions + 2 vertices. The mirrors x -> -x, y -> -y, z -> -z map vertices and faces onto each
/// other without any rounding: a start in the plane of shear has the symmetry of the flow to the last bit.
Icosphere make_icosphere(int subdivisions);

}  // namespace capstan
