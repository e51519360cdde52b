#pragma once
// The single layer potential: the velocity that forces on the membrane drive in an unbounded fluid of
// viscosity 1 (Pozrikidis 1992, eq. 2.3.3),
//   u(x0) = 1/(8 pi) int G(x - x0) f dA.
// Quadrature: far from x0 the vertex rule. On the faces that touch x0 the singularity 1/r is integrated
// analytically along rays from x0 (Duffy's transformation), with f linear on the face. On the next ring of
// faces the three-point rule is used: without it the operator of a stretched mesh is not positive definite,
// and triangles collapse. Where the surface comes near to itself, faces are split.
#include "solver/fluid/stokes/neighbourhood.hpp"

namespace capstan {

/// \param forces  3 x #V, by the membrane on the fluid, integrated over each vertex's share of the membrane
/// \param close   result of neighbourhood.close_faces(surface)
/// \return velocities, 3 x #targets
Points single_layer(const Surface& surface, const Neighbourhood& neighbourhood,
                    const std::vector<CloseFace>& close, const Points& forces);

}  // namespace capstan
