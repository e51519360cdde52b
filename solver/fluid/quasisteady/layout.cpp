#include "solver/fluid/quasisteady/layout.hpp"

#include "solver/case/fidelity.hpp"

namespace capstan {
namespace {

// Measured against the uniform grid (README, "A grid around the capsule"): the velocity at the membrane
// changes by less than 1e-3. Cells of the grid itself, on every side.
constexpr int kMarginOfFinest = 6, kMarginOfNext = 4;
constexpr int kSlack = 2;          // the capsule moves so far before its box does
constexpr int kClearOfSides = 4;   // a box closer to a side of the domain ends there
constexpr double kMaxShare = 0.5;  // of the domain that a box may have before it is all of it

int rounded_up_to_even(int n) { return (n + 1) & ~1; }

/// Whole cells of the coarser grid; with the symmetry, from the axis of the half-turn to equal distances in
/// x.
IndexBox aligned(IndexBox box, bool is_quarter) {
  for (int axis = 0; axis < 3; ++axis) box.lo[axis] &= ~1, box.hi[axis] = rounded_up_to_even(box.hi[axis]);
  if (!is_quarter) return box;
  box.hi[0] = std::max(-box.lo[0], box.hi[0]);
  box.lo = {-box.hi[0], 0, 0};
  return box;
}

IndexBox fitted(IndexBox box, const Domain& domain, int grid) {
  const IndexBox all = domain.box(grid);
  box = aligned(box, domain.is_quarter);
  for (int axis = 0; axis < 3; ++axis) {
    const bool low =
        box.lo[axis]<all.lo[axis] + kClearOfSides, high = box.hi[axis]> all.hi[axis] - kClearOfSides;
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
    if (!current.empty() && box != domain.box(grid)) {
      const IndexBox needed = fitted(grown(inner, margin - kSlack), domain, grid);
      if (still_fits(current[grid], needed, box)) box = current[grid];
    }
    boxes.push_back(box);
    inner = coarsened(box);
  }
  return boxes;
}

}  // namespace capstan
