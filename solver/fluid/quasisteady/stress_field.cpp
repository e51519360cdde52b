#include "solver/fluid/quasisteady/stress_field.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solver/fluid/quasisteady/moment_images.hpp"
#include "solver/grid/transfers.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

constexpr std::array<double, kStresses> kToCoarse = {2, 2, 2, 2, 2}, kToFine = {0.5, 0.5, 0.5, 0.5, 0.5};

/// The cells of a box that are in one row.
IndexBox row_of(const IndexBox& box, int y, int z) { return {{box.lo[0], y, z}, {box.hi[0], y + 1, z + 1}}; }

/// c = 1 - s = 1 - 1/(3 nu + 1/2) with nu = ratio / 6. Returns whether any c is not 0.
template <class T>
CAPSTAN_VECTOR_UNITS bool put_factors(const double* ratio, T* __restrict c, int count) {
  int nonzero = 0;
  for (int i = 0; i < count; ++i) {
    c[i] = T(1 - 2 / (1 + ratio[i]));
    nonzero += c[i] != 0;
  }
  return nonzero > 0;
}

/// numbers <- 0 where c = 0.
template <class T>
CAPSTAN_VECTOR_UNITS void clear_where_zero(const T* __restrict c, T* __restrict numbers, int count) {
  for (int i = 0; i < count; ++i) numbers[i] = c[i] != 0 ? numbers[i] : T(0);
}

}  // namespace

template <class T>
StressField<T>::StressField(const IndexBox& box, const SideRules& rules)
    : rules_(rules),
      state_{RowField<T>(box, kStresses), RowField<T>(box, kStresses)},
      factor_(box, 1),
      rows_(std::size_t(box.size(1)) * box.size(2), true),
      defect_(box, kStresses),
      scratch_{RowField<T>(box, kStresses), RowField<T>(box, kStresses)} {}

template <class T>
void StressField<T>::set_viscosity(const ScalarField& ratio) {
  std::ranges::fill(factor_.data(), T(0));
  const int first = ratio.box().lo[0] - box().lo[0];
  std::vector<char> has_other_viscosity(rows_.size(), false);
  for_each_row_in_order(ratio.box(), [&](int y, int z) {
    has_other_viscosity[row_index(y, z)] =
        put_factors(ratio.row(0, y, z), factor_.row(0, y, z) + first, ratio.box().size(0));
  });
  capstan::fill_ghosts(factor_, rules_, kScalarImages);
  const std::vector<char> rows = rows_near(has_other_viscosity);
  clear_rows_outside(rows);
  rows_ = rows;
}

template <class T>
std::vector<char> StressField<T>::rows_near(const std::vector<char>& rows) const {
  std::vector<char> near(rows.size(), false);
  for_each_row_in_order(box(), [&](int y, int z) {
    if (!rows[row_index(y, z)]) return;
    // all rows with the same coarse parents as this row and the rows next to it
    const IndexBox family{{0, (y - 1) & ~1, (z - 1) & ~1}, {1, ((y + 1) | 1) + 1, ((z + 1) | 1) + 1}};
    const IndexBox yz{{0, box().lo[1], box().lo[2]}, {1, box().hi[1], box().hi[2]}};
    for_each_row_in_order(intersection(family, yz),
                          [&](int near_y, int near_z) { near[row_index(near_y, near_z)] = true; });
  });
  return near;
}

template <class T>
void StressField<T>::clear_rows_outside(const std::vector<char>& rows) {
  for_each_computed_row(box(), [&](int y, int z) {
    if (rows[row_index(y, z)]) return;
    for (RowField<T>* field : {&state_.now, &state_.before, &defect_, &scratch_.next, &scratch_.start})
      std::ranges::fill(field->whole_row(y, z), T(0));
  });
}

template <class T>
void StressField<T>::clear_defect() {
  for_each_computed_row(box(), [&](int y, int z) { std::ranges::fill(defect_.whole_row(y, z), T(0)); });
}

template <class T>
void StressField<T>::fill_ghosts() {
  capstan::fill_ghosts(state_.now, rules_, kStressImages);
}

template <class T>
StressRow<T> StressField<T>::row(const FluidRow<T>& fluid, int y, int z, T keep, T blend, T undisturbed) {
  return {.fluid = fluid,
          .factor = factor_.row(0, y, z),
          .factor_strides = factor_.strides(),
          .p = state_.now.row(0, y, z),
          .p_defect = defect_.row(0, y, z),
          .p_out = scratch_.next.row(0, y, z),
          .stress_strides = state_.now.strides(),
          .p_keep = keep,
          .p_blend = blend,
          .undisturbed = undisturbed};
}

template <class T>
void StressField<T>::restrict_to(StressField& coarse) const {
  const IndexBox covered = coarsened(box());
  coarse.for_each_computed_row(covered, [&](int y, int z) {
    average_children(state_.now, coarse.state_.now, row_of(covered, y, z), kToCoarse);
  });
}

/// D_H = A_H(I P) + I' r_h, as MomentGrid::take_defect: scratch_.next holds the residuals of both grids.
/// Residuals of cells with c = 0 are set to zero, because the stress of these cells has no effect.
template <class T>
void StressField<T>::take_defect(StressField& fine) {
  fine.for_each_computed_row(fine.box(), [&](int y, int z) {
    for (int k = 0; k < kStresses; ++k)
      clear_where_zero(fine.factor_.row(0, y, z), fine.scratch_.next.row(k, y, z), fine.box().size(0));
  });
  const IndexBox covered = coarsened(fine.box());
  RowField<T>& fine_residual = scratch_.start;
  for_each_computed_row(covered, [&](int y, int z) {
    average_children(fine.scratch_.next, fine_residual, row_of(covered, y, z), kToCoarse);
    add_difference(fine_residual, scratch_.next, defect_, row_of(covered, y, z));
  });
  for_each_computed_row(box(), [&](int y, int z) {
    std::ranges::copy(state_.now.whole_row(y, z), scratch_.start.whole_row(y, z).begin());
  });
}

/// scratch_.start <- P - scratch_.start, ghosts included.
template <class T>
void StressField<T>::take_change() {
  for_each_computed_row(box(), [&](int y, int z) {
    take_difference(state_.now.whole_row(y, z), scratch_.start.whole_row(y, z));
  });
  capstan::fill_ghosts(scratch_.start, rules_, kStressImages);
}

template <class T>
void StressField<T>::correct_from(const StressField& coarse) {
  for_each_computed_row(box(), [&](int y, int z) {
    add_linear(coarse.scratch_.start, state_.now, row_of(box(), y, z), kToFine);
  });
}

template <class T>
void StressField<T>::move_to(const IndexBox& box, const SideRules& rules) {
  rules_ = rules;
  for (RowField<T>* field : {&state_.now, &state_.before}) {
    RowField<T>& moved = scratch_.next;
    moved.reset(box);
    copy_cells(*field, moved);
    std::swap(*field, moved);
  }
  for (RowField<T>* field : {&scratch_.next, &scratch_.start, &defect_, &factor_}) field->reset(box);
  rows_.assign(std::size_t(box.size(1)) * box.size(2), true);
}

template <class T>
void StressField<T>::extrapolate(double weight) {
  for_each_computed_row(box(), [&](int y, int z) {
    capstan::extrapolate(state_.now.whole_row(y, z), state_.before.whole_row(y, z), weight);
  });
}

template class StressField<float>;
template class StressField<double>;

}  // namespace capstan
