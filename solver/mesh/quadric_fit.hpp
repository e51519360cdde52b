#pragma once
// Normal and curvatures of the smooth surface at each vertex, from a quadric that is fitted to its neighbours
// (Garimella and Swartz, LA-UR-03-8240, 2003).
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct QuadricFit {
  Points normals;    ///< 3 x #V, unit, outward
  Scalars mean;      ///< #V: H = (k1 + k2)/2, positive on a sphere
  Scalars gaussian;  ///< #V: K = k1 k2
};

/// Fits the quadric  z = a x^2 + b x y + c y^2 + d x + e y  to the one-ring of each vertex by least squares,
/// in a frame at the vertex whose third axis is the vertex normal. Five neighbours determine the coefficients
/// exactly.
QuadricFit fit_quadrics(const TriangleMesh& mesh, const Points& positions);

}  // namespace capstan
