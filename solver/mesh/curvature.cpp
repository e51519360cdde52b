#include "solver/mesh/curvature.hpp"

#include <array>

namespace capstan {
namespace {

/// The geometry of one face as the cotangent formula needs it.
struct CotangentFace {
  std::array<Vec3, 3> opposite;  ///< side opposite to each corner, counter-clockwise
  Vec3 cotangents;               ///< of the angles at the corners
  double area;

  CotangentFace(const Points& x, const Eigen::Vector3i& face) {
    for (int corner : {0, 1, 2})
      opposite[corner] = x.col(face[(corner + 2) % 3]) - x.col(face[(corner + 1) % 3]);
    const double twice_area = opposite[0].cross(opposite[1]).norm();
    for (int corner : {0, 1, 2})
      cotangents[corner] = -opposite[(corner + 1) % 3].dot(opposite[(corner + 2) % 3]) / twice_area;
    area = twice_area / 2;
  }

  /// Mixed Voronoi area of each corner; the three sum up to the area of the face.
  Vec3 shares() const {
    for (int obtuse : {0, 1, 2})
      if (cotangents[obtuse] < 0) {
        Vec3 shares = Vec3::Constant(area / 4);
        shares[obtuse] = area / 2;
        return shares;
      }
    Vec3 by_side;
    for (int corner : {0, 1, 2}) by_side[corner] = opposite[corner].squaredNorm() * cotangents[corner] / 8;
    return Vec3::Constant(by_side.sum()) - by_side;
  }
};

/// The Laplace-Beltrami operator applied to k functions, k x #V: the sum of the fluxes along the edges into
/// each vertex over its mixed area.
template <int k>
Eigen::Matrix<double, k, Eigen::Dynamic> laplacian(const Faces& faces, const Points& positions,
                                                   const Eigen::Matrix<double, k, Eigen::Dynamic>& values) {
  Eigen::Matrix<double, k, Eigen::Dynamic> flux =
      Eigen::Matrix<double, k, Eigen::Dynamic>::Zero(k, values.cols());
  Scalars areas = Scalars::Zero(values.cols());
  for (const auto& face : faces.colwise()) {
    const CotangentFace here(positions, face);
    const Vec3 shares = here.shares();
    for (int corner : {0, 1, 2}) {
      const int i = face[(corner + 1) % 3], j = face[(corner + 2) % 3];
      const Eigen::Matrix<double, k, 1> flow = here.cotangents[corner] / 2 * (values.col(j) - values.col(i));
      flux.col(i) += flow, flux.col(j) -= flow;
      areas[face[corner]] += shares[corner];
    }
  }
  return flux.array().rowwise() / areas.transpose().array();
}

}  // namespace

Scalars mixed_areas(const Points& positions, const Faces& faces) {
  Scalars areas = Scalars::Zero(positions.cols());
  for (const auto& face : faces.colwise()) {
    const Vec3 shares = CotangentFace(positions, face).shares();
    for (int corner : {0, 1, 2}) areas[face[corner]] += shares[corner];
  }
  return areas;
}

Scalars laplace_beltrami(const Faces& faces, const Points& positions, const Scalars& values) {
  return laplacian<1>(faces, positions, values.transpose()).transpose();
}

Scalars mean_curvature(const Faces& faces, const Points& positions, const Points& normals) {
  return -laplacian<3>(faces, positions, positions).cwiseProduct(normals).colwise().sum().transpose() / 2;
}

}  // namespace capstan
