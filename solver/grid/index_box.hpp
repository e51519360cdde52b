#pragma once
// Boxes of cells by their integer indices: every field on a grid is defined over such a box.
//
// The cells of a grid and of the next coarser one, of twice the spacing, are numbered so that the cell i of
// the coarse grid consists of the fine cells 2 i and 2 i + 1 in each direction. The parent of a cell i is
// therefore floor(i/2), for negative indices too. GridGeometry (solver/coupling) has the position of the cell
// 0 in space.
#include <algorithm>
#include <array>
#include <cstddef>

namespace capstan {

/// Cells lo <= (x, y, z) < hi.
struct IndexBox {
  std::array<int, 3> lo{}, hi{};

  bool operator==(const IndexBox&) const = default;
  constexpr int size(int axis) const { return hi[axis] - lo[axis]; }
  constexpr long cells() const { return long(size(0)) * size(1) * size(2); }
  bool has_row(int y, int z) const { return y >= lo[1] && y < hi[1] && z >= lo[2] && z < hi[2]; }
  bool contains(const IndexBox& other) const {
    for (int axis = 0; axis < 3; ++axis)
      if (other.lo[axis] < lo[axis] || other.hi[axis] > hi[axis]) return false;
    return true;
  }
};

/// Distances in memory from a number of a field to the next component of the same cell, and to the same
/// component of the cells at y + 1 and at z + 1. Cells along x are contiguous.
struct Strides {
  std::ptrdiff_t component, y, z;
};

/// The cells 0 <= (x, y, z) < sizes.
constexpr IndexBox box_from_zero(std::array<int, 3> sizes) { return {{0, 0, 0}, sizes}; }

inline int parent(int i) { return i >> 1; }

/// The parents of all cells of a box.
inline IndexBox coarsened(IndexBox box) {
  for (int axis = 0; axis < 3; ++axis)
    box.lo[axis] = parent(box.lo[axis]), box.hi[axis] = parent(box.hi[axis] + 1);
  return box;
}

/// The children of all cells of a box.
inline IndexBox refined(IndexBox box) {
  for (int axis = 0; axis < 3; ++axis) box.lo[axis] *= 2, box.hi[axis] *= 2;
  return box;
}

/// The box with `cells` more cells on every side; fewer if negative.
inline IndexBox grown(IndexBox box, int cells) {
  for (int axis = 0; axis < 3; ++axis) box.lo[axis] -= cells, box.hi[axis] += cells;
  return box;
}

/// The cells that both boxes have in common; an empty box if there are none.
inline IndexBox intersection(const IndexBox& a, const IndexBox& b) {
  IndexBox both;
  for (int axis = 0; axis < 3; ++axis) {
    both.lo[axis] = std::max(a.lo[axis], b.lo[axis]);
    both.hi[axis] = std::max(both.lo[axis], std::min(a.hi[axis], b.hi[axis]));
  }
  return both;
}

/// The index 0 <= i < n of which `index`, at most one cell outside of this range, is the periodic image.
inline int periodic(int index, int n) { return index < 0 ? index + n : index >= n ? index - n : index; }

}  // namespace capstan
