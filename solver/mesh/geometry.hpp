#pragma once
// Size and moments of a closed triangulated surface. Normals point outwards. Every function is exact for the
// polyhedron it is given; volume, area and moments are of second order in the edge length for the smooth
// surface behind it.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// 3 x #F: unit normal times area of each face.
Points face_area_vectors(const Points& positions, const Faces& faces);
Scalars face_areas(const Points& positions, const Faces& faces);

/// A third of the areas of the faces around each vertex; they sum up to the area.
Scalars vertex_areas(const Points& positions, const Faces& faces);

/// 3 x #V: N_i = dV/dx_i, the gradient of the volume; a third of the area vectors around each vertex.
Points vertex_area_vectors(const Points& positions, const Faces& faces);

/// Unit vectors along N_i: the area-weighted mean of the normals around each vertex.
/// They are of first order in the edge length only.
Points vertex_normals(const Points& positions, const Faces& faces);

double area(const Points& positions, const Faces& faces);
double volume(const Points& positions, const Faces& faces);

/// Centre of the enclosed volume.
Vec3 centroid(const Points& positions, const Faces& faces);

/// Second moments M_ij = int_V r_i r_j dV about the centroid. An ellipsoid has M = V/5 diag(a^2, b^2, c^2).
Eigen::Matrix3d second_moments(const Points& positions, const Faces& faces);

/// Inertia tensor about the centroid, paper eq. 44: I_ij = int_V (r_k r_k delta_ij - r_i r_j) dV.
Eigen::Matrix3d inertia_tensor(const Points& positions, const Faces& faces);

}  // namespace capstan
