#include "solver/fluid/stokes/double_layer.hpp"

#include <numbers>

#include "solver/fluid/stokes/quadrature.hpp"

namespace capstan {
namespace {

/// T_ijk(r) N_k as a matrix (i, j).
Eigen::Matrix3d stresslet(const Vec3& r, const Vec3& area_vector) {
  const double r2 = r.squaredNorm();
  return -6 * r.dot(area_vector) / (r2 * r2 * std::sqrt(r2)) * r * r.transpose();
}

}  // namespace

DoubleLayer::DoubleLayer(const Surface& surface, const Neighbourhood& neighbourhood,
                         const std::vector<CloseFace>& close)
    : surface_(surface), targets_(neighbourhood.targets()) {
  area_vectors_.assign(surface.vertex_area_vectors);
  corrections_.reserve(close.size());
  for (const CloseFace& here : close)
    corrections_.push_back(make_correction(surface, targets_[here.slot], here));
}

DoubleLayer::Correction DoubleLayer::make_correction(const Surface& surface, int target,
                                                     const CloseFace& here) {
  Correction correction{here.slot, surface.mesh.faces.col(here.face), {}};
  const Vec3 x0 = surface.positions.col(target), area_vector = surface.face_area_vectors.col(here.face);
  const Eigen::Matrix3d x = surface.positions(Eigen::all, correction.corners);
  for (int c : {0, 1, 2}) correction.of_corner[c] = -stresslet(x.col(c) - x0, area_vector / 3);
  for (const TrianglePoint& point : refined_rule(x, x0)) {
    const Eigen::Matrix3d here_only = stresslet(x * point.barycentric - x0, point.weight * area_vector);
    for (int c : {0, 1, 2}) correction.of_corner[c] += point.barycentric[c] * here_only;
  }
  return correction;
}

Points DoubleLayer::apply(const Points& velocities) const {
  PointArray u;
  u.assign(velocities);
  Points result(3, targets_.size());
#pragma omp parallel for schedule(static)
  for (int slot = 0; slot < int(targets_.size()); ++slot) {
    const int target = targets_[slot];
    result.col(slot) =
        sum_stresslets(surface_.points, area_vectors_, u, surface_.positions.col(target).cast<float>(),
                       velocities.col(target).cast<float>())
            .cast<double>();
  }
  for (const Correction& correction : corrections_)
    for (int c : {0, 1, 2})
      result.col(correction.slot) += correction.of_corner[c] * (velocities.col(correction.corners[c]) -
                                                                velocities.col(targets_[correction.slot]));
  return result / (8 * std::numbers::pi);
}

}  // namespace capstan
