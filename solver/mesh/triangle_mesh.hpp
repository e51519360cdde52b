#pragma once
// Topology of a closed, oriented triangle mesh. Vertex positions are stored separately, as Points.
#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace capstan {

using Vec3 = Eigen::Vector3d;
using Points = Eigen::Matrix3Xd;  ///< 3 x #V, a vector at each vertex: positions / a, velocities / (a k),
                                  ///< forces / (mu_a k a^2)
using Faces = Eigen::Matrix3Xi;   ///< 3 x #F, counter-clockwise seen from outside
using Scalars = Eigen::VectorXd;  ///< #V or #F, a number at each vertex or face

/// An edge with its two faces: (vertices[0], vertices[1], opposite[0]) is faces[0] and (vertices[1],
/// vertices[0], opposite[1]) is faces[1], both counter-clockwise.
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
