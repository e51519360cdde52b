#include "solver/mesh/quadric_fit.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "solver/mesh/geometry.hpp"

namespace capstan {
namespace {

/// a, b, c, d, e of the quadric.
using Coefficients = Eigen::Matrix<double, 5, 1>;

/// An orthonormal frame whose third column is the normal.
Eigen::Matrix3d frame_about(const Vec3& normal) {
  Eigen::Matrix3d frame;
  frame.col(2) = normal;
  frame.col(0) = normal.unitOrthogonal();
  frame.col(1) = normal.cross(frame.col(0));
  return frame;
}

/// Lengths are divided by `size`, about one edge, so that the normal equations are well conditioned.
Coefficients fit(const std::vector<int>& ring, const Vec3& centre, const Eigen::Matrix3d& frame, double size,
                 const Points& positions) {
  Eigen::Matrix<double, 5, 5> normal_matrix = Eigen::Matrix<double, 5, 5>::Zero();
  Coefficients right_side = Coefficients::Zero();
  for (int neighbour : ring) {
    const Vec3 r = frame.transpose() * (positions.col(neighbour) - centre) / size;
    Coefficients row;
    row << r.x() * r.x(), r.x() * r.y(), r.y() * r.y(), r.x(), r.y();
    normal_matrix += row * row.transpose();
    right_side += row * r.z();
  }
  Coefficients scaled = normal_matrix.llt().solve(right_side);
  scaled.head<3>() /= size;
  return scaled;
}

}  // namespace

// The graph z(x, y) with slopes p, q and second derivatives r, s, t at the vertex has, with its normal along
// +z,
//   k1 + k2 = ((1 + q^2) r - 2 p q s + (1 + p^2) t) / w^3,   k1 k2 = (r t - s^2) / w^4,
// w^2 = 1 + p^2 + q^2. Here k1 + k2 is negative on a sphere with its outward normal, so 2H = -(k1 + k2).
QuadricFit fit_quadrics(const TriangleMesh& mesh, const Points& positions) {
  const Points estimates = vertex_normals(positions, mesh.faces);
  QuadricFit result{Points(3, positions.cols()), Scalars(positions.cols()), Scalars(positions.cols())};
  for (int vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    const std::vector<int>& ring = mesh.one_ring[vertex];
    const Vec3 centre = positions.col(vertex);
    const Eigen::Matrix3d frame = frame_about(estimates.col(vertex));
    const double size = (positions.col(ring.front()) - centre).norm();
    const Coefficients z = fit(ring, centre, frame, size, positions);
    const double p = z[3], q = z[4], r = 2 * z[0], s = z[1], t = 2 * z[2];
    const double w2 = 1 + p * p + q * q, w = std::sqrt(w2);
    result.normals.col(vertex) = frame * Vec3(-p, -q, 1) / w;
    result.mean[vertex] = -((1 + q * q) * r - 2 * p * q * s + (1 + p * p) * t) / (2 * w * w2);
    result.gaussian[vertex] = (r * t - s * s) / (w2 * w2);
  }
  return result;
}

}  // namespace capstan
