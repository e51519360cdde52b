#include "solver/fluid/quasisteady/symmetric_boundary.hpp"

#include <algorithm>

namespace capstan {
namespace {

/// visit(row of the extended box, row of the quarter, sign, whether x is reversed), for all rows and
/// components.
template <class Extended, class Quarter, class Visit>
void for_each_image(Extended& extended, Quarter& quarter, Visit visit) {
  extended.for_each_row([&](int y, int z) {
    const bool is_turned = y < 0, is_mirrored = z < 0;
    for (int c = 0; c < 3; ++c) {
      const double sign = ((is_turned && c < 2) ? -1 : 1) * ((is_mirrored && c == 2) ? -1 : 1);
      visit(extended.row(c, y, z), quarter.row(c, is_turned ? -1 - y : y, is_mirrored ? -1 - z : z), sign,
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

/// The cells that the representatives' delta functions touch; in x to equal distances if there is a
/// half-turn.
IndexBox SymmetricBoundary::extended() const {
  IndexBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = boundary_.box_lo()[axis];
    box.hi[axis] = box.lo[axis] + boundary_.box_size()[axis];
  }
  if (!has_symmetry()) return box;
  box.hi[0] = std::max(-box.lo[0], box.hi[0]);
  box.lo[0] = -box.hi[0];
  return box;
}

IndexBox SymmetricBoundary::touched(int margin) const {
  IndexBox box = grown(extended(), margin);
  if (has_symmetry()) box.lo[1] = box.lo[2] = 0;
  return box;
}

void SymmetricBoundary::spread(const Points& forces, double scale, VectorBox& box) {
  const IndexBox cells = touched(), all = extended();
  box.reset(cells.lo, cells.sizes());
  Points shares = orbits_.restrict(forces);
  if (!has_symmetry()) return boundary_.spread(shares, scale, box);
  shares = folded(shares);
  for (Eigen::Index k = 0; k < shares.cols(); ++k) shares.col(k) *= orbits_.size(int(k)) / 4.0;
  extended_box_.reset(all.lo, all.sizes());
  boundary_.spread(shares, scale, extended_box_);
  const int n = box.size()[0];
  for_each_image(extended_box_, box, [n](const double* from, double* to, double sign, bool is_reversed) {
    for (int i = 0; i < n; ++i) to[i] += sign * from[is_reversed ? n - 1 - i : i];
  });
}

void SymmetricBoundary::interpolate(const VectorBox& box, Points& velocities) {
  Points at_representatives(3, signs_.cols());
  if (has_symmetry()) {
    const IndexBox all = extended();
    extended_box_.reset(all.lo, all.sizes());
    const int n = box.size()[0];
    for_each_image(extended_box_, box, [n](double* to, const double* from, double sign, bool is_reversed) {
      for (int i = 0; i < n; ++i) to[i] = sign * from[is_reversed ? n - 1 - i : i];
    });
    boundary_.interpolate(extended_box_, 1, at_representatives);
  } else {
    boundary_.interpolate(box, 1, at_representatives);
  }
  velocities = orbits_.extend(folded(at_representatives));
}

}  // namespace capstan
