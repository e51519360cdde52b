#pragma once
// The smooth surface near each vertex: a quadric through it, fitted to its neighbours
// (Garimella and Swartz, LA-UR-03-8240, 2003).
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct QuadricFit {
  Points normals;    ///< 3 x #V, unit, outward
  Scalars mean;      ///< #V: H = (k1 + k2)/2, positive on a sphere
  Scalars gaussian;  ///< #V: K = k1 k2
};

/// In a frame at the vertex whose third axis is the vertex normal the surface is
///   z = a x^2 + b x y + c y^2 + d x + e y,
/// least squares over the one-ring; five neighbours determine it, six over-determine it.
QuadricFit fit_quadrics(const TriangleMesh& mesh, const Points& positions);

}  // namespace capstan
