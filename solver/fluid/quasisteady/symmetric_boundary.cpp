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

bool SymmetricBoundary::place(const Points& positions) {
  const Points of_representatives = orbits_.restrict(positions);
  signs_ = Points::Ones(3, of_representatives.cols());
  if (has_symmetry())
    for (Eigen::Index k = 0; k < signs_.cols(); ++k) {
      if (of_representatives(1, k) < 0) signs_(0, k) = signs_(1, k) = -1;
      if (of_representatives(2, k) < 0) signs_(2, k) = -1;
    }
  return boundary_.place(folded(of_representatives), 0);
}

Points SymmetricBoundary::folded(const Points& of_representatives) const {
  return signs_.cwiseProduct(of_representatives);
}

/// The cells in the supports of the representatives' delta functions; with symmetry, extended in x to equal
/// distances on both sides of the axis of the half-turn.
IndexBox SymmetricBoundary::unfolded() const {
  IndexBox box = boundary_.box();
  if (!has_symmetry()) return box;
  box.hi[0] = std::max(-box.lo[0], box.hi[0]);
  box.lo[0] = -box.hi[0];
  return box;
}

IndexBox SymmetricBoundary::touched(int margin) const {
  IndexBox box = grown(unfolded(), margin);
  if (has_symmetry()) box.lo[1] = box.lo[2] = 0;
  return box;
}

void SymmetricBoundary::spread(const Points& forces, double scale, VectorField& field) {
  field.reset(touched());
  Points shares = orbits_.restrict(forces);
  if (!has_symmetry()) return boundary_.spread(shares, scale, field);
  shares = folded(shares);
  for (Eigen::Index k = 0; k < shares.cols(); ++k) shares.col(k) *= orbits_.size(int(k)) / 4.0;
  unfolded_.reset(unfolded());
  boundary_.spread(shares, scale, unfolded_);
  const int n = field.box().size(0);
  for_each_image(unfolded_, field, [n](const double* from, double* to, double sign, bool is_reversed) {
    for (int i = 0; i < n; ++i) to[i] += sign * from[is_reversed ? n - 1 - i : i];
  });
}

void SymmetricBoundary::interpolate(const VectorField& field, Points& velocities) {
  Points at_representatives(3, signs_.cols());
  if (has_symmetry()) {
    unfolded_.reset(unfolded());
    const int n = field.box().size(0);
    for_each_image(unfolded_, field, [n](double* to, const double* from, double sign, bool is_reversed) {
      for (int i = 0; i < n; ++i) to[i] = sign * from[is_reversed ? n - 1 - i : i];
    });
    boundary_.interpolate(unfolded_, 1, at_representatives);
  } else {
    boundary_.interpolate(field, 1, at_representatives);
  }
  velocities = orbits_.extend(folded(at_representatives));
}

}  // namespace capstan
