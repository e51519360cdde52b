#pragma once
// Transfers between a grid and the next coarser one, of twice the spacing. A coarse cell receives the mean of
// its eight children; values of fine cells are interpolated. Each component is multiplied by a factor of its
// own, because the lattice units depend on the spacing.
#include <array>
#include <span>

#include "solver/grid/row_field.hpp"

namespace capstan {

/// coarse = factor * mean of the children, in the cells of `region` (indices of the coarse grid).
template <class T>
void average_children(const RowField<T>& fine, RowField<T>& coarse, const IndexBox& region,
                      std::span<const double> factors);

/// fine += factor * trilinear interpolation of coarse, in the cells of `region` (indices of the fine grid).
/// The coarse ghosts are used.
template <class T>
void add_linear(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                std::span<const double> factors);

/// fine = factor * interpolation of coarse by parabolas in each direction, in the cells of `region` (indices
/// of the fine grid; may contain its ghosts). The coarse ghosts are used.
template <class T>
void interpolate(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                 std::span<const double> factors);

/// Component 0 of four rows of a field.
template <class T>
using FourRows = std::array<const T*, 4>;

/// The four rows of children of the coarse row (y, z): (2y, 2z), (2y + 1, 2z), (2y, 2z + 1), (2y + 1, 2z +
/// 1), from the first child of the coarse cell x on.
template <class T>
FourRows<T> rows_of_children(const RowField<T>& fine, int x, int y, int z) {
  const auto row = [&](int dy, int dz) {
    return fine.row(0, 2 * y + dy, 2 * z + dz) + (2 * x - fine.box().lo[0]);
  };
  return {row(0, 0), row(1, 0), row(0, 1), row(1, 1)};
}

/// The four coarse rows nearest to the fine row (y, z): that of its parents, and its neighbours towards the
/// fine row in y, in z and in both, from the coarse cell x on. A fine centre is a quarter of a coarse cell
/// away from its parent's, so linear interpolation gives them the weights 9/16, 3/16, 3/16 and 1/16.
template <class T>
FourRows<T> rows_around(const RowField<T>& coarse, int x, int y, int z) {
  const int near_y = (y & 1) ? parent(y) + 1 : parent(y) - 1,
            near_z = (z & 1) ? parent(z) + 1 : parent(z) - 1;
  const auto row = [&](int at_y, int at_z) { return coarse.row(0, at_y, at_z) + (x - coarse.box().lo[0]); };
  return {row(parent(y), parent(z)), row(near_y, parent(z)), row(parent(y), near_z), row(near_y, near_z)};
}

}  // namespace capstan
