#pragma once
// Area, volume and moments of a closed triangulated surface. Normals point outwards. All functions are exact
// for the polyhedron; for the smooth surface that it approximates, volume, area and moments are of second
// order in the edge length.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// 3 x #F: unit normal times area of each face.
Points face_area_vectors(const Points& positions, const Faces& faces);

/// #F
Scalars face_areas(const Points& positions, const Faces& faces);

/// #V: a third of the areas of the faces around each vertex; the sum is the area of the surface.
Scalars vertex_areas(const Points& positions, const Faces& faces);

/// 3 x #V: N_i = dV/dx_i, the gradient of the volume: a third of the area vectors around each vertex.
Points vertex_area_vectors(const Points& positions, const Faces& faces);

/// 3 x #V: unit vectors along N_i, the area-weighted mean of the normals around each vertex. Only of first
/// order in the edge length.
Points vertex_normals(const Points& positions, const Faces& faces);

double area(const Points& positions, const Faces& faces);
double volume(const Points& positions, const Faces& faces);

/// Centroid of the enclosed volume.
Vec3 centroid(const Points& positions, const Faces& faces);

/// Second moments M_ij = int_V r_i r_j dV about the centroid. An ellipsoid has M = V/5 diag(a^2, b^2, c^2).
Eigen::Matrix3d second_moments(const Points& positions, const Faces& faces);

/// Inertia tensor about the centroid, paper eq. 44: I_ij = int_V (r_k r_k delta_ij - r_i r_j) dV.
Eigen::Matrix3d inertia_tensor(const Points& positions, const Faces& faces);

}  // namespace capstan
