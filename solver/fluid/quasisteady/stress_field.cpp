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

/// The factors c of the arithmetic mean and c_H - c, from the part of ambient fluid in each cell for either
/// mean.
template <class T>
CAPSTAN_VECTOR_UNITS bool put_factors(const double* ambient, const double* ambient_of_shear, double V,
                                      T* __restrict arithmetic, T* __restrict harmonic, int count) {
  int nonzero = 0;
  for (int i = 0; i < count; ++i) {
    const double H = ambient[i], H_shear = ambient_of_shear[i];
    const double R = H + (1 - H) * V, R_H = V / (H_shear * V + (1 - H_shear));
    const double c = 1 - 2 / (1 + R);
    arithmetic[i] = T(c);
    harmonic[i] = T(1 - 2 / (1 + R_H) - c);
    nonzero += arithmetic[i] != 0;
  }
  return nonzero > 0;
}

/// numbers <- 0 where c = 0.
template <class T>
CAPSTAN_VECTOR_UNITS void clear_where_zero(const T* __restrict c, T* __restrict numbers, int count) {
  for (int i = 0; i < count; ++i) numbers[i] = c[i] != 0 ? numbers[i] : T(0);
}

/// result = share (a - b) where c is not 0, else 0.
template <class T>
CAPSTAN_VECTOR_UNITS void put_where_nonzero(const T* __restrict c, const T* __restrict a,
                                            const T* __restrict b, T share, T* __restrict result, int count) {
  for (int i = 0; i < count; ++i) result[i] = c[i] != 0 ? share * (a[i] - b[i]) : T(0);
}

/// The mean with the weights 1/4 1/2 1/4 of each number and those at a distance of `step`.
template <class T>
CAPSTAN_VECTOR_UNITS void put_mean(const T* __restrict row, std::ptrdiff_t step, T* __restrict result,
                                   int count) {
  for (int i = 0; i < count; ++i) result[i] = T(0.5) * row[i] + T(0.25) * (row[i - step] + row[i + step]);
}

}  // namespace

template <class T>
StressField<T>::StressField(const IndexBox& box, const SideRules& rules)
    : rules_(rules),
      state_{RowField<T>(box, kStresses), RowField<T>(box, kStresses)},
      interface_(box, kInterfaces),
      rows_(std::size_t(box.size(1)) * box.size(2), true),
      has_normals_(rows_.size(), false),
      defect_(box, kStresses),
      scratch_{RowField<T>(box, kStresses), RowField<T>(box, kStresses), RowField<T>(box, kStresses)} {}

template <class T>
void StressField<T>::set_viscosity(const ScalarField& ratio) {
  std::ranges::fill(interface_.data(), T(0));
  const int first = ratio.box().lo[0] - box().lo[0];
  std::vector<char> has_other_viscosity(rows_.size(), false);
  for_each_row_in_order(ratio.box(), [&](int y, int z) {
    has_other_viscosity[row_index(y, z)] =
        put_factors(ratio.row(0, y, z), interface_.row(kArithmetic, y, z) + first, ratio.box().size(0));
  });
  select_rows(has_other_viscosity);
}

template <class T>
void StressField<T>::set_viscosity(const InterfaceField& interface, double V) {
  std::ranges::fill(interface_.data(), T(0));
  std::ranges::fill(has_normals_, false);
  const int first = interface.box().lo[0] - box().lo[0], count = interface.box().size(0);
  std::vector<char> has_other_viscosity(rows_.size(), false);
  for_each_row_in_order(interface.box(), [&](int y, int z) {
    T* factors = interface_.row(kArithmetic, y, z) + first;
    const std::ptrdiff_t stride = interface_.strides().component;
    has_other_viscosity[row_index(y, z)] =
        put_factors(interface.row(kAmbientPartAlong, y, z), interface.row(kAmbientPartOfShear, y, z), V,
                    factors, factors + kHarmonic * stride, count);
    for (int axis = 0; axis < 3; ++axis) {
      const double* normal = interface.row(kMembraneNormal + axis, y, z);
      T* to = factors + (kNormalX + axis) * stride;
      for (int i = 0; i < count; ++i) {
        to[i] = T(normal[i]);
        if (to[i] != 0) has_normals_[row_index(y, z)] = true;
      }
    }
  });
  select_rows(has_other_viscosity);
}

template <class T>
void StressField<T>::select_rows(const std::vector<char>& has_other_viscosity) {
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
    for (RowField<T>* field :
         {&state_.now, &state_.before, &defect_, &scratch_.next, &scratch_.start, &scratch_.passed})
      std::ranges::fill(field->whole_row(y, z), T(0));
  });
}

template <class T>
void StressField<T>::clear_defect() {
  for_each_computed_row(box(), [&](int y, int z) { std::ranges::fill(defect_.whole_row(y, z), T(0)); });
}

template <class T>
TensorRow<T> StressField<T>::tensor_row(int y, int z, double undisturbed) {
  return {.p = state_.now.row(kXX, y, z),
          .q = scratch_.passed.row(kXX, y, z),
          .stress_stride = state_.now.strides().component,
          .interface = interface_.row(kArithmetic, y, z),
          .interface_stride = interface_.strides().component,
          .count = box().size(0),
          .undisturbed = T(undisturbed)};
}

template <class T>
void StressField<T>::put_passed_stress(double undisturbed) {
  for_each_computed_row(box(), [&](int y, int z) {
    capstan::put_passed_stress(tensor_row(y, z, undisturbed), has_normals_[row_index(y, z)]);
  });
  capstan::fill_ghosts(scratch_.passed, rules_, kStressImages);
}

template <class T>
void StressField<T>::put_local_stress(double share, double undisturbed, const RowField<T>& zero,
                                      RowField<T>& unused) {
  for_each_computed_row(box(), [&](int y, int z) {
    put_stress_without_shear(tensor_row(y, z, undisturbed), has_normals_[row_index(y, z)]);
  });
  capstan::fill_ghosts(scratch_.passed, rules_, kStressImages);
  clear_defect();  // the sweep adds D
  for_each_computed_row(box(), [&](int y, int z) {
    const FluidRow<T> nothing{.m = zero.row(0, y, z),
                              .defect = zero.row(0, y, z),
                              .out = unused.row(0, y, z),
                              .strides = zero.strides(),
                              .count = box().size(0),
                              .keep = 0,
                              .blend = 1,
                              .g_keep = 0,
                              .g_blend = 1};
    sweep_stress(row(nothing, y, z, T(0), T(1)));  // A[c P'] in scratch_.next
  });
  for_each_computed_row(box(), [&](int y, int z) {
    for (int k = 0; k < kStresses; ++k)
      put_where_nonzero(interface_.row(kArithmetic, y, z), scratch_.passed.row(k, y, z),
                        scratch_.next.row(k, y, z), T(share), defect_.row(k, y, z), box().size(0));
  });
  smooth_defect();
}

/// D <- L[D]
template <class T>
void StressField<T>::smooth_defect() {
  const Strides& strides = defect_.strides();
  for (const std::ptrdiff_t step : {std::ptrdiff_t(1), strides.y, strides.z})
    for (int pass = 0; pass < 2; ++pass) {
      capstan::fill_ghosts(defect_, rules_, kStressImages);
      for_each_computed_row(box(), [&](int y, int z) {
        for (int k = 0; k < kStresses; ++k)
          put_mean(defect_.row(k, y, z), step, scratch_.next.row(k, y, z), box().size(0));
      });
      std::swap(defect_, scratch_.next);
    }
}

template <class T>
StressRow<T> StressField<T>::row(const FluidRow<T>& fluid, int y, int z, T keep, T blend) {
  return {.fluid = fluid,
          .factor = interface_.row(kArithmetic, y, z),
          .q = scratch_.passed.row(0, y, z),
          .p = state_.now.row(0, y, z),
          .p_defect = defect_.row(0, y, z),
          .p_out = scratch_.next.row(0, y, z),
          .stress_strides = state_.now.strides(),
          .p_keep = keep,
          .p_blend = blend};
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
      clear_where_zero(fine.interface_.row(kArithmetic, y, z), fine.scratch_.next.row(k, y, z),
                       fine.box().size(0));
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
  for (RowField<T>* field : {&scratch_.next, &scratch_.start, &scratch_.passed, &defect_, &interface_})
    field->reset(box);
  rows_.assign(std::size_t(box.size(1)) * box.size(2), true);
  has_normals_.assign(rows_.size(), false);
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
