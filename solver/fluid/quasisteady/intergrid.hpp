#pragma once
// Between a grid and the next coarser one, of twice the spacing. A value of a coarse cell is the mean of its
// eight children's; a fine value is interpolated. Numbers change with the spacing (see grid.hpp), so each
// component has a factor.
#include <span>

#include "solver/grid/row_field.hpp"

namespace capstan {

/// coarse = factor * mean of the children, in the cells of `region` (of the coarse grid).
template <class T>
void average_children(const RowField<T>& fine, RowField<T>& coarse, const IndexBox& region,
                      std::span<const double> factors);

/// fine += factor * coarse, interpolated linearly in each direction, in the cells of `region` (of the fine
/// grid). The coarse ghosts are used.
template <class T>
void add_linear(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                std::span<const double> factors);

/// fine = factor * coarse, interpolated by parabolas in each direction, in the cells of `region` (of the fine
/// grid, its ghosts possibly).
template <class T>
void interpolate(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                 std::span<const double> factors);

}  // namespace capstan
