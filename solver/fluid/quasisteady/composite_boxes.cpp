#include "solver/fluid/quasisteady/composite_boxes.hpp"

#include <algorithm>

#include "solver/grid/halved_cells.hpp"

namespace capstan {
namespace {

// Margins in cells on every side: of the finest grid around the capsule, and of each coarser grid around the
// next finer one. With these margins Q = D_xy (cos 2 theta, sin 2 theta) differs by at most 5e-4 from that on
// a uniform grid, to kt = 10 (spheres, a prolate capsule and red cells, V = 0.2 to 10, dx = 0.2).
constexpr int kMarginOfFinest = 4, kMarginOfNext = 3;
constexpr int kSlack = 2;        // cells by which the capsule can move before the box must follow it
constexpr int kLeastMargin = 2;  // the interpolation of ghosts reads two coarse cells beyond a side
constexpr int kMinGap = 2;  // in cells; a side of a box nearer than this to that of the domain is moved to it
constexpr double kMaxShare =
    0.7;  // a box with a larger share of the domain's cells is extended to the whole domain

int rounded_up_to_even(int n) { return (n + 1) & ~1; }

/// Extends a box to whole cells of the next coarser grid; in a quarter of the domain also to y = z = 0, and
/// in x to equal distances from the axis of the half-turn.
IndexBox aligned(IndexBox box, bool is_quarter) {
  for (int axis = 0; axis < 3; ++axis) box.lo[axis] &= ~1, box.hi[axis] = rounded_up_to_even(box.hi[axis]);
  if (!is_quarter) return box;
  box.hi[0] = std::max(-box.lo[0], box.hi[0]);
  box.lo = {-box.hi[0], 0, 0};
  return box;
}

/// The box of a grid that has to cover `box`: aligned, and extended to sides of the domain that are near.
IndexBox fitted(IndexBox box, const Domain& domain, int grid) {
  const IndexBox all = domain.box(grid);
  box = aligned(box, domain.is_quarter);
  for (int axis = 0; axis < 3; ++axis) {
    const bool low = box.lo[axis]<all.lo[axis] + kMinGap, high = box.hi[axis]> all.hi[axis] - kMinGap;
    const bool goes_around = domain.rules().side[axis][0] == SideRule::periodic && (low || high);
    if (low || goes_around) box.lo[axis] = all.lo[axis];
    if (high || goes_around) box.hi[axis] = all.hi[axis];
  }
  return double(box.cells()) > kMaxShare * double(all.cells()) ? all : box;
}

bool still_fits(const IndexBox& box, const IndexBox& needed, const IndexBox& wanted) {
  return box.contains(needed) && grown(wanted, 2 * kSlack).contains(box);
}

}  // namespace

int Domain::grid_count() const { return int(halved_cells(cells).size()); }

IndexBox Domain::box(int grid) const {
  const int half = (cells >> grid) / 2, low = is_quarter ? 0 : -half;
  return {{-half, low, low}, {half, half, half}};
}

SideRules Domain::rules() const {
  using enum SideRule;
  if (is_quarter) return {{{{periodic, periodic}, {half_turn, wall}, {mirror, mirror}}}};
  return {{{{periodic, periodic}, {wall, wall}, {periodic, periodic}}}};
}

std::vector<IndexBox> plan_boxes(const Domain& domain, const IndexBox& capsule,
                                 const std::vector<IndexBox>& current) {
  std::vector<IndexBox> boxes;
  IndexBox inner = capsule;
  for (int grid = 0; grid < domain.grid_count(); ++grid) {
    const int margin = grid == 0 ? kMarginOfFinest : kMarginOfNext;
    IndexBox box = domain.is_uniform ? domain.box(grid) : fitted(grown(inner, margin), domain, grid);
    if (grid + 1 == domain.grid_count()) box = domain.box(grid);  // no coarser grid could give it ghosts
    if (!current.empty() && box != domain.box(grid)) {
      const IndexBox needed = fitted(grown(inner, std::max(margin - kSlack, kLeastMargin)), domain, grid);
      if (still_fits(current[grid], needed, box)) box = current[grid];
    }
    boxes.push_back(box);
    inner = coarsened(box);
  }
  return boxes;
}

}  // namespace capstan
