#include "solver/fluid/quasisteady/stress.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solver/fluid/quasisteady/intergrid.hpp"
#include "solver/fluid/quasisteady/sweep.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

constexpr std::array<double, kStresses> kToCoarse = {2, 2, 2, 2, 2}, kToFine = {0.5, 0.5, 0.5, 0.5, 0.5};

/// Cells of `box` in one row.
IndexBox row_of(const IndexBox& box, int y, int z) { return {{box.lo[0], y, z}, {box.hi[0], y + 1, z + 1}}; }

/// c = 1 - s = 1 - 1/(3 nu + 1/2) with nu = ratio/6; whether any is not 0.
template <class T>
CAPSTAN_VECTOR_UNITS bool put_contrast(const double* ratio, T* __restrict c, int count) {
  int contrasts = 0;
  for (int i = 0; i < count; ++i) {
    c[i] = T(1 - 2 / (1 + ratio[i]));
    contrasts += c[i] != 0;
  }
  return contrasts > 0;
}

template <class T>
CAPSTAN_VECTOR_UNITS void clear_where_none(const T* __restrict c, T* __restrict numbers, int count) {
  for (int i = 0; i < count; ++i) numbers[i] = c[i] != 0 ? numbers[i] : T(0);
}

}  // namespace

template <class T>
StressField<T>::StressField(const IndexBox& box, const SideRules& rules)
    : p(box, kStresses),
      out(box, kStresses),
      before(box, kStresses),
      start(box, kStresses),
      defect(box, kStresses),
      c(box, 1),
      rules_(rules),
      rows_(std::size_t(box.size(1)) * box.size(2), true) {}

template <class T>
void StressField<T>::set_viscosity(const ScalarBox& viscosity) {
  std::ranges::fill(c.data(), T(0));
  const int first = viscosity.lo()[0] - c.box().lo[0];
  std::vector<char> contrasts(rows_.size(), false);
  viscosity.for_each_row([&](int y, int z) {
    contrasts[row_index(y, z)] =
        put_contrast(viscosity.row(0, y, z), c.row(0, y, z) + first, viscosity.size()[0]);
  });
  capstan::fill_ghosts(c, rules_, kScalarParity);
  const std::vector<char> rows = rows_near(contrasts);
  clear_rows_outside(rows);
  rows_ = rows;
}

template <class T>
std::vector<char> StressField<T>::rows_near(const std::vector<char>& rows) const {
  const IndexBox& box = c.box();
  std::vector<char> near(rows.size(), false);
  for (int z = box.lo[2]; z < box.hi[2]; ++z)
    for (int y = box.lo[1]; y < box.hi[1]; ++y) {
      if (!rows[row_index(y, z)]) continue;
      // all children of the parents of the rows around
      const int first_y = (y - 1) & ~1, last_y = (y + 1) | 1, first_z = (z - 1) & ~1, last_z = (z + 1) | 1;
      for (int near_z = std::max(first_z, box.lo[2]); near_z <= std::min(last_z, box.hi[2] - 1); ++near_z)
        for (int near_y = std::max(first_y, box.lo[1]); near_y <= std::min(last_y, box.hi[1] - 1); ++near_y)
          near[row_index(near_y, near_z)] = true;
    }
  return near;
}

template <class T>
void StressField<T>::clear_rows_outside(const std::vector<char>& rows) {
  for_each_row(c.box(), [&](int y, int z) {
    if (rows[row_index(y, z)]) return;
    for (RowField<T>* field : {&p, &out, &start, &defect, &before})
      std::ranges::fill(field->whole_row(y, z), T(0));
  });
}

template <class T>
void StressField<T>::clear_defect() {
  for_each_row(c.box(), [&](int y, int z) { std::ranges::fill(defect.whole_row(y, z), T(0)); });
}

template <class T>
void StressField<T>::fill_ghosts() {
  capstan::fill_ghosts(p, rules_, kStressParity);
}

template <class T>
void StressField<T>::restrict_to(StressField& coarse) const {
  const IndexBox covered = coarsened(c.box());
  coarse.for_each_row(covered,
                      [&](int y, int z) { average_children(p, coarse.p, row_of(covered, y, z), kToCoarse); });
}

/// D = I P - P**(I m) + I' r, where `out` holds the residuals of both grids. Those of cells without contrast
/// are left out: their stress has no effect.
template <class T>
void StressField<T>::take_defect(StressField& fine) {
  fine.for_each_row(fine.c.box(), [&](int y, int z) {
    for (int k = 0; k < kStresses; ++k)
      clear_where_none(fine.c.row(0, y, z), fine.out.row(k, y, z), fine.c.box().size(0));
  });
  const IndexBox covered = coarsened(fine.c.box());
  for_each_row(covered, [&](int y, int z) {
    average_children(fine.out, start, row_of(covered, y, z), kToCoarse);
    add_difference(start, out, defect, row_of(covered, y, z));
  });
  for_each_row(c.box(),
               [&](int y, int z) { std::ranges::copy(p.whole_row(y, z), start.whole_row(y, z).begin()); });
}

template <class T>
void StressField<T>::take_change() {
  for_each_row(c.box(), [&](int y, int z) { take_difference(p.whole_row(y, z), start.whole_row(y, z)); });
  capstan::fill_ghosts(start, rules_, kStressParity);
}

template <class T>
void StressField<T>::correct_from(const StressField& coarse) {
  for_each_row(c.box(), [&](int y, int z) { add_linear(coarse.start, p, row_of(c.box(), y, z), kToFine); });
}

template <class T>
void StressField<T>::move_to(const IndexBox& box, const SideRules& rules) {
  rules_ = rules;
  for (RowField<T>* field : {&p, &before}) {
    out.reset(box);
    copy_cells(*field, out);
    std::swap(*field, out);
  }
  for (RowField<T>* field : {&out, &start, &defect, &c}) field->reset(box);
  rows_.assign(std::size_t(box.size(1)) * box.size(2), true);
}

template <class T>
void StressField<T>::extrapolate(double weight) {
  for_each_row(c.box(), [&](int y, int z) {
    capstan::extrapolate(p.whole_row(y, z), before.whole_row(y, z), weight);
  });
}

template class StressField<float>;
template class StressField<double>;

}  // namespace capstan
