#pragma once
// Curvature of a triangulated surface at its vertices. H = (k1 + k2)/2 is positive on a sphere with its
// outward normal; K = k1 k2.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// The part of the surface that is nearer to each vertex than to any other, Voronoi's, with Meyer's remedy at
/// obtuse triangles (Meyer et al. 2003); the parts sum up to the area.
Scalars mixed_areas(const Points& positions, const Faces& faces);

/// The Laplace-Beltrami operator on a vertex function, by the cotangent formula:
///   (Delta f)_i = 1/A_i sum_j (cot alpha + cot beta)/2 (f_j - f_i),
/// alpha and beta the angles opposite to the edge, A_i the mixed area.
/// Differs from the paper: eq. 32 is printed with f_i - f_j, which is the negative of the operator.
Scalars laplace_beltrami(const Faces& faces, const Points& positions, const Scalars& values);

/// H of each vertex from the cotangent formula:  Delta x = -2 H n.
/// \param normals unit ones at the vertices
Scalars mean_curvature(const Faces& faces, const Points& positions, const Points& normals);

}  // namespace capstan
