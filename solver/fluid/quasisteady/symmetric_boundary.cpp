#include "solver/fluid/quasisteady/symmetric_boundary.hpp"

#include <algorithm>

#include "solver/grid/for_each_row.hpp"

namespace capstan {
namespace {

/// Calls visit(row of the unfolded field, row of the quarter that it is an image of, sign, whether x is
/// reversed) for all rows and components.
template <class Unfolded, class Quarter, class Visit>
void for_each_image(Unfolded& unfolded, Quarter& quarter, Visit visit) {
  for_each_row_in_order(unfolded.box(), [&](int y, int z) {
    const bool is_turned = y < 0, is_mirrored = z < 0;
    for (int c = 0; c < 3; ++c) {
      const double sign = ((is_turned && c < 2) ? -1 : 1) * ((is_mirrored && c == 2) ? -1 : 1);
      visit(unfolded.row(c, y, z), quarter.row(c, is_turned ? -1 - y : y, is_mirrored ? -1 - z : z), sign,
            is_turned);
    }
  });
}

}  // namespace

SymmetricBoundary::SymmetricBoundary(const GridGeometry& grid, Orbits orbits)
    : orbits_(std::move(orbits)), boundary_(grid) {}

bool SymmetricBoundary::place(const Points& positions, const Points& normals) {
  const Points of_representatives = orbits_.restrict(positions);
  signs_ = Points::Ones(3, of_representatives.cols());
  if (has_symmetry())
    for (Eigen::Index k = 0; k < signs_.cols(); ++k) {
      if (of_representatives(1, k) < 0) signs_(0, k) = signs_(1, k) = -1;
      if (of_representatives(2, k) < 0) signs_(2, k) = -1;
    }
  normals_ = folded(orbits_.restrict(normals));
  return boundary_.place(folded(of_representatives));
}

Points SymmetricBoundary::folded(const Points& of_representatives) const {
  return signs_.cwiseProduct(of_representatives);
}

/// What each representative spreads in the quarter: the other members of its orbit spread the rest.
Points SymmetricBoundary::shares(const Points& of_vertices) const {
  Points shares = folded(orbits_.restrict(of_vertices));
  if (has_symmetry())
    for (Eigen::Index k = 0; k < shares.cols(); ++k) shares.col(k) *= orbits_.size(int(k)) / 4.0;
  return shares;
}

/// The cells in the supports of the representatives' sharpened kernels; with symmetry, extended in x to equal
/// distances on both sides of the axis of the half-turn.
IndexBox SymmetricBoundary::unfolded() const {
  IndexBox box = grown(boundary_.box(), kSharpeningReach);
  if (!has_symmetry()) return box;
  box.hi[0] = std::max(-box.lo[0], box.hi[0]);
  box.lo[0] = -box.hi[0];
  return box;
}

IndexBox SymmetricBoundary::touched() const {
  IndexBox box = unfolded();
  if (has_symmetry()) box.lo[1] = box.lo[2] = 0;
  return box;
}

/// quarter <- unfolded_, with the cells beyond the planes added to their images.
void SymmetricBoundary::fold(VectorField& quarter) {
  if (!has_symmetry()) return std::swap(quarter, unfolded_);
  quarter.reset(touched());
  const int n = quarter.box().size(0);
  for_each_image(unfolded_, quarter, [n](const double* from, double* to, double sign, bool is_reversed) {
    for (int i = 0; i < n; ++i) to[i] += sign * from[is_reversed ? n - 1 - i : i];
  });
}

/// unfolded_ <- quarter, and its images beyond the planes.
void SymmetricBoundary::unfold(const VectorField& quarter) {
  if (!has_symmetry()) {
    unfolded_ = quarter;
    return;
  }
  unfolded_.reset(unfolded());
  const int n = quarter.box().size(0);
  for_each_image(unfolded_, quarter, [n](double* to, const double* from, double sign, bool is_reversed) {
    for (int i = 0; i < n; ++i) to[i] = sign * from[is_reversed ? n - 1 - i : i];
  });
}

void SymmetricBoundary::spread(const Points& forces, const Points& dipoles, double scale,
                               VectorField& field) {
  Tensors tensors(9, 0);
  if (dipoles.cols() > 0) {
    const Points S = shares(dipoles);
    tensors.resize(9, S.cols());
    for (Eigen::Index k = 0; k < S.cols(); ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          tensors(3 * i + j, k) = S(i, k) * normals_(j, k) + normals_(i, k) * S(j, k);
  }
  unfolded_.reset(unfolded());
  boundary_.spread(shares(forces), tensors, scale, unfolded_);
  sharpening_.apply(unfolded_);
  fold(field);
}

void SymmetricBoundary::interpolate(const VectorField& field, Points& velocities) {
  Points at_representatives;
  unfold(field);
  sharpening_.apply(unfolded_);
  boundary_.interpolate(unfolded_, at_representatives);
  velocities = orbits_.extend(folded(at_representatives));
}

void SymmetricBoundary::interpolate(const VectorField& field, Points& velocities, Points& shears) {
  Points at_representatives;
  Tensors gradients;
  unfold(field);
  sharpening_.apply(unfolded_);
  boundary_.interpolate(unfolded_, at_representatives, gradients);
  Points of_representatives(3, signs_.cols());
  for (Eigen::Index k = 0; k < signs_.cols(); ++k) {
    Eigen::Matrix3d gradient = gradients.col(k).reshaped(3, 3).transpose();
    gradient(0, 1) += 1;  // (y, 0, 0) has the symmetry of the quarter
    of_representatives.col(k) = (gradient + gradient.transpose()) * normals_.col(k);
  }
  velocities = orbits_.extend(folded(at_representatives));
  shears = orbits_.extend(folded(of_representatives));
}

Points SymmetricBoundary::smoothed(const Points& vectors, double scale) {
  unfolded_.reset(unfolded());
  boundary_.spread(shares(vectors), Tensors(9, 0), scale, unfolded_);
  fold(quarter_);
  unfold(quarter_);
  Points at_representatives;
  boundary_.interpolate(unfolded_, at_representatives);
  return orbits_.extend(folded(at_representatives));
}

}  // namespace capstan
