#pragma once
// Curvature of a triangulated surface at its vertices. H = (k1 + k2)/2 is positive on a sphere with its
// outward normal; K = k1 k2.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// #V: the area that belongs to each vertex, by the mixed Voronoi scheme of Meyer et al. (2003), which treats
/// obtuse triangles separately. The sum over all vertices is the area of the surface.
Scalars mixed_areas(const Points& positions, const Faces& faces);

/// The Laplace-Beltrami operator on a vertex function, by the cotangent formula:
///   (Delta f)_i = 1/A_i sum_j (cot alpha + cot beta)/2 (f_j - f_i),
/// where alpha and beta are the angles opposite to the edge ij and A_i is the mixed area.
/// \param values  #V
/// Differs from the paper: eq. 32 is printed with f_i - f_j, which is the negative of the operator.
Scalars laplace_beltrami(const Faces& faces, const Points& positions, const Scalars& values);

/// #V: H from the cotangent formula,  Delta x = -2 H n.
/// \param normals  3 x #V, of unit length
Scalars mean_curvature(const Faces& faces, const Points& positions, const Points& normals);

}  // namespace capstan
