#pragma once
// How well flat triangles stand for a smooth membrane: a mesh resolves a surface whose neighbouring faces
// nearly share a plane. A membrane under compression without bending stiffness crumples down to the size of
// the triangles; what it does then is a property of the mesh.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

inline constexpr double kFoldedEdge = 60;  ///< degrees; smooth surfaces have 6 to 18 with 642 vertices

struct SurfaceQuality {
  double largest_dihedral = 0;  ///< degrees between the normals of two neighbouring faces
  double folded_edges = 0;      ///< share of the edges whose angle is above kFoldedEdge
  double smallest_angle = 60;   ///< of a triangle, degrees
  bool operator==(const SurfaceQuality&) const = default;
};

SurfaceQuality surface_quality(const TriangleMesh& mesh, const Points& positions);

/// The worse of each.
SurfaceQuality worst_of(const SurfaceQuality& a, const SurfaceQuality& b);

}  // namespace capstan
