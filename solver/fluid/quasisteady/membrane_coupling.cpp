#include "solver/fluid/quasisteady/membrane_coupling.hpp"

#include <cmath>
#include <utility>

#include "solver/mesh/geometry.hpp"

namespace capstan {

MembraneCoupling::MembraneCoupling(const GridGeometry& grid, const TriangleMesh& mesh, Orbits orbits,
                                   double V, std::optional<double> volume)
    : dx_(grid.dx),
      faces_(mesh.faces),
      volume_(volume),
      corrections_(layer_corrections(V)),
      boundary_(grid, std::move(orbits)) {}

bool MembraneCoupling::place(const Points& positions) {
  positions_ = positions;
  area_vectors_ = vertex_area_vectors(positions, faces_);
  area_ = area_vectors_.colwise().norm().sum();
  normals_ = area_vectors_.colwise().normalized();
  present_volume_ = volume(positions, faces_);
  return boundary_.place(positions, normals_);
}

/// (I - n n) vectors
Points MembraneCoupling::tangential(const Points& vectors) const {
  Points result = vectors;
  for (Eigen::Index k = 0; k < vectors.cols(); ++k)
    result.col(k) -= normals_.col(k) * normals_.col(k).dot(vectors.col(k));
  return result;
}

/// s (I - n n) vectors + t n n vectors
Points MembraneCoupling::of_dipoles(const Points& vectors) const {
  const Points along = tangential(vectors);
  return dx_ * (corrections_.slip * along + corrections_.tension * (vectors - along));
}

void MembraneCoupling::spread(const Points& forces, double scale, VectorField& field) {
  const double pressure = forces.cwiseProduct(normals_).sum() / area_;
  const Points along = tangential(forces);
  kinks_ = corrections_.kink == 0
               ? Points(Points::Zero(3, forces.cols()))
               : tangential(boundary_.smoothed(along, corrections_.kink / dx_));  // dx^2 delta / dx^3
  const Points without_pressure = forces - pressure * area_vectors_;
  boundary_.spread(without_pressure, has_dipoles() ? of_dipoles(without_pressure) : Points(3, 0), scale,
                   field);
}

void MembraneCoupling::read(const VectorField& field, Points& velocities) {
  if (has_dipoles()) {
    Points shears;
    boundary_.interpolate(field, velocities, shears);
    velocities += of_dipoles(shears);
  } else {
    boundary_.interpolate(field, velocities);
  }
  velocities += kinks_;
  velocities.row(0) += positions_.row(1);
  constexpr double kReturnRate = 5;  // k; ab2 is stable with it for steps below 0.2
  const double flux = velocities.cwiseProduct(area_vectors_).sum();
  leak_ = std::abs(flux / present_volume_);
  const double excess = volume_ ? present_volume_ - *volume_ : 0;
  velocities -= (flux + kReturnRate * excess) / area_ * normals_;
}

}  // namespace capstan
