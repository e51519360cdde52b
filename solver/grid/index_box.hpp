#pragma once
// Boxes of cells by their integer indices. At spacing dx the centre of cell i stands at (i + 1/2) dx from the
// domain's centre, so the parent of cell i at twice the spacing is floor(i/2), for negative indices too.
#include <algorithm>
#include <array>

namespace capstan {

/// Cells lo <= (x, y, z) < hi.
struct IndexBox {
  std::array<int, 3> lo{}, hi{};

  bool operator==(const IndexBox&) const = default;
  int size(int axis) const { return hi[axis] - lo[axis]; }
  std::array<int, 3> sizes() const { return {size(0), size(1), size(2)}; }
  long cells() const { return long(size(0)) * size(1) * size(2); }
  bool contains(const IndexBox& other) const {
    for (int axis = 0; axis < 3; ++axis)
      if (other.lo[axis] < lo[axis] || other.hi[axis] > hi[axis]) return false;
    return true;
  }
};

inline int parent(int i) { return i >> 1; }

/// All parents of a box's cells.
inline IndexBox coarsened(IndexBox box) {
  for (int axis = 0; axis < 3; ++axis)
    box.lo[axis] = parent(box.lo[axis]), box.hi[axis] = parent(box.hi[axis] + 1);
  return box;
}

/// All children.
inline IndexBox refined(IndexBox box) {
  for (int axis = 0; axis < 3; ++axis) box.lo[axis] *= 2, box.hi[axis] *= 2;
  return box;
}

/// `cells` more on every side, or fewer.
inline IndexBox grown(IndexBox box, int cells) {
  for (int axis = 0; axis < 3; ++axis) box.lo[axis] -= cells, box.hi[axis] += cells;
  return box;
}

inline IndexBox intersection(const IndexBox& a, const IndexBox& b) {
  IndexBox both;
  for (int axis = 0; axis < 3; ++axis) {
    both.lo[axis] = std::max(a.lo[axis], b.lo[axis]);
    both.hi[axis] = std::max(both.lo[axis], std::min(a.hi[axis], b.hi[axis]));
  }
  return both;
}

}  // namespace capstan
