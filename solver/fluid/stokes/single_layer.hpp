#pragma once
// The velocity that forces on the membrane drive in an unbounded fluid of viscosity 1 (Pozrikidis 1992,
// eq. 2.3.3):
//   u(x0) = 1/(8 pi) int G(x - x0) f dA
// The vertex rule far away. On the faces that touch x0 the 1/r is integrated exactly along the rays from x0
// (Duffy), with f linear on the face; on the next ring three Gauss points serve: without them the operator of
// a stretched mesh is not positive, and its triangles collapse. Where the surface comes near to itself, faces
// are split.
#include "solver/fluid/stokes/neighbourhood.hpp"

namespace capstan {

/// \param forces 3 x #V, by the membrane on the fluid, integrated over each vertex's share
/// \param close  of neighbourhood.close_faces(surface)
/// \return 3 x #targets
Points single_layer(const Surface& surface, const Neighbourhood& neighbourhood,
                    const std::vector<CloseFace>& close, const Points& forces);

}  // namespace capstan
