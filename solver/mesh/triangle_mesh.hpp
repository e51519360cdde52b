#pragma once
// A closed, oriented triangle mesh: who is joined to whom. Positions live beside it, in Points.
#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace capstan {

using Vec3 = Eigen::Vector3d;
using Points = Eigen::Matrix3Xd;  ///< 3 x #V, one column a vertex: positions / a, velocities / (a k), forces
using Faces = Eigen::Matrix3Xi;   ///< 3 x #F, counter-clockwise seen from outside
using Scalars = Eigen::VectorXd;  ///< one number a vertex (or a face)

/// An inner edge with its two triangles: (vertices[0], vertices[1], opposite[0]) has the orientation of
/// face[0], (vertices[1], vertices[0], opposite[1]) that of face[1].
struct Edge {
  std::array<int, 2> vertices;
  std::array<int, 2> opposite;
  std::array<int, 2> faces;
};

struct TriangleMesh {
  Faces faces;
  std::vector<Edge> edges;
  std::vector<std::vector<int>> one_ring;  ///< neighbours of each vertex, counter-clockwise

  int vertex_count() const { return static_cast<int>(one_ring.size()); }
};

/// Edges and one-rings of a closed, oriented, manifold set of faces.
TriangleMesh make_mesh(const Faces& faces, int vertex_count);

}  // namespace capstan
