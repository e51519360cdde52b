#pragma once
// How well a triangulation resolves a smooth membrane: the angle between neighbouring faces must be small. A
// membrane under compression without bending stiffness wrinkles down to the size of the triangles; such a
// result depends on the mesh.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// Above this angle in degrees between two triangles a membrane without bending stiffness wrinkles.
inline constexpr double kWrinkledEdge = 40;
inline constexpr double kFoldedEdge = 60;  ///< degrees; edges of smooth shapes with 642 vertices have 6 to 18

struct SurfaceQuality {
  double largest_dihedral = 0;  ///< largest angle between the normals of two neighbouring faces, degrees
  double folded_edges = 0;      ///< fraction of the edges with an angle above kFoldedEdge
  double smallest_angle = 60;   ///< smallest angle of a triangle, degrees
  double longest_edge = 0;      ///< in units of a
  bool operator==(const SurfaceQuality&) const = default;
};

SurfaceQuality surface_quality(const TriangleMesh& mesh, const Points& positions);

/// Two edges are needed for a wave: shorter wrinkles than this cannot be seen on the mesh, and wrinkles of
/// about this length are as wide as the mesh makes them. In units of a.
double smallest_wavelength(const SurfaceQuality& quality);

/// The worse of each number of the two.
SurfaceQuality worst_of(const SurfaceQuality& a, const SurfaceQuality& b);

}  // namespace capstan
