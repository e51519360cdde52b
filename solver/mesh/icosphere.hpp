#pragma once
// A nearly uniform triangulation of the unit sphere: an icosahedron whose faces are repeatedly split into
// four, or first into nine and then into four.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct Icosphere {
  Points directions;  ///< 3 x #V, unit vectors
  TriangleMesh mesh;
};

/// The sphere with 10 * 4^subdivisions + 2 vertices. The reflections x -> -x, y -> -y and z -> -z map
/// vertices and faces onto each other without rounding, so that a capsule made from it has the symmetry of
/// the flow exactly.
Icosphere make_icosphere(int subdivisions);

/// The sphere with 10 f^2 + 2 vertices, f = 2^n or 3 * 2^n: the edges of the icosahedron are divided into f
/// parts. It has the same reflections. \param nodes  one of kIcosphereNodes
Icosphere icosphere_with(int nodes);

}  // namespace capstan
