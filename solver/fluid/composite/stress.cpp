#include "solver/fluid/composite/stress.hpp"

#include <algorithm>
#include <array>

#include "solver/coupling/vector_units.hpp"
#include "solver/fluid/composite/intergrid.hpp"
#include "solver/fluid/composite/sweep.hpp"

namespace capstan {
namespace {

constexpr std::array<double, kStresses> kToCoarse = {2, 2, 2, 2, 2}, kToFine = {0.5, 0.5, 0.5, 0.5, 0.5};

RowSpan united(const RowSpan& a, const RowSpan& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

IndexBox row_box(const IndexBox& box, const RowSpan& span, int y, int z) {
  return {{box.lo[0] + span.first, y, z}, {box.lo[0] + span.last, y + 1, z + 1}};
}

/// q = c (p + undisturbed) in a row's span.
template <class T>
CAPSTAN_VECTOR_UNITS void weigh(const T* __restrict c, const T* __restrict p, T* __restrict q,
                                const RowSpan& span, T undisturbed) {
  for (int i = span.first; i < span.last; ++i) q[i] = c[i] * (p[i] + undisturbed);
}

}  // namespace

template <class T>
StressField<T>::StressField(const IndexBox& box, const SideRules& rules, double couette_stress)
    : p(box, kStresses),
      out(box, kStresses),
      before(box, kStresses),
      start(box, kStresses),
      defect(box, kStresses),
      q(box, kStresses),
      c(box, 1),
      rules_(rules),
      couette_stress_(T(couette_stress)),
      spans_(std::size_t(box.size(1)) * box.size(2), RowSpan{0, box.size(0)}) {}

template <class T>
void StressField<T>::set_viscosity(const ScalarBox& viscosity) {
  std::ranges::fill(c.data(), T(0));
  const IndexBox& box = c.box();
  viscosity.for_each_row([&](int y, int z) {
    T* row = c.row(0, y, z) + (viscosity.lo()[0] - box.lo[0]);
    const double* ratio = viscosity.row(0, y, z);  // s = 1/(3 nu + 1/2) with nu = ratio/6
    for (int i = 0; i < viscosity.size()[0]; ++i) row[i] = T(1 - 2 / (1 + ratio[i]));
  });
  clear_outside(find_spans());
}

template <class T>
std::vector<RowSpan> StressField<T>::find_spans() const {
  const IndexBox& box = c.box();
  std::vector<RowSpan> contrast(spans_.size()), spans(spans_.size());
  for (int z = box.lo[2]; z < box.hi[2]; ++z)
    for (int y = box.lo[1]; y < box.hi[1]; ++y) {
      const T* row = c.row(0, y, z);
      RowSpan& span = contrast[row_index(y, z)];
      for (int i = 0; i < box.size(0); ++i)
        if (row[i] != 0) span = united(span, {i, i + 1});
    }
  const auto contrast_at = [&](int y, int z) {
    const bool inside = y >= box.lo[1] && y < box.hi[1] && z >= box.lo[2] && z < box.hi[2];
    return inside ? contrast[row_index(y, z)] : RowSpan{};
  };
  for (int z = box.lo[2]; z < box.hi[2]; ++z)
    for (int y = box.lo[1]; y < box.hi[1]; ++y) {
      RowSpan& span = spans[row_index(y, z)];
      const int first_y = y & ~1, first_z = z & ~1;  // the older sibling
      for (int near_z = first_z - 1; near_z <= first_z + 2; ++near_z)
        for (int near_y = first_y - 1; near_y <= first_y + 2; ++near_y)
          span = united(span, contrast_at(near_y, near_z));
      if (span.empty()) continue;
      const int lo = box.lo[0];
      span.first = std::max(0, ((span.first + lo - 1) & ~1) - lo);
      span.last = std::min(box.size(0), ((span.last + lo + 2) & ~1) - lo);
    }
  return spans;
}

/// What was in a span and is no longer becomes zero.
template <class T>
void StressField<T>::clear_outside(const std::vector<RowSpan>& spans) {
  for_each_span([&](const RowSpan& old, int y, int z) {
    const RowSpan now = spans[row_index(y, z)];
    for (RowField<T>* field : {&p, &out, &start, &defect, &q, &before})
      for (int k = 0; k < kStresses; ++k) {
        T* row = field->row(k, y, z);
        std::fill(row + old.first, row + std::clamp(now.first, old.first, old.last), T(0));
        std::fill(row + std::clamp(now.last, old.first, old.last), row + old.last, T(0));
      }
  });
  spans_ = spans;
}

template <class T>
void StressField<T>::clear_defect() {
  for_each_span([&](const RowSpan& span, int y, int z) {
    for (int k = 0; k < kStresses; ++k)
      std::fill_n(defect.row(k, y, z) + span.first, span.last - span.first, T(0));
  });
}

template <class T>
void StressField<T>::update_q() {
  for_each_span([&](const RowSpan& span, int y, int z) {
    const T* contrast = c.row(0, y, z);
    for (int k = 0; k < kStresses; ++k)
      weigh(contrast, p.row(k, y, z), q.row(k, y, z), span, k == kXY ? couette_stress_ : T(0));
  });
  fill_ghosts(q, rules_, kStressParity);
}

template <class T>
void StressField<T>::restrict_to(StressField& coarse) const {
  coarse.for_each_span([&](const RowSpan& span, int y, int z) {
    average_children(p, coarse.p, row_box(coarse.c.box(), span, y, z), kToCoarse);
  });
}

/// D = I P - P**(I m) + I' r, where `out` holds the residuals of both grids. Those of cells without contrast
/// are left out: their stress has no effect.
template <class T>
void StressField<T>::take_defect(StressField& fine) {
  fine.for_each_span([&](const RowSpan& span, int y, int z) {
    const T* contrast = fine.c.row(0, y, z);
    for (int k = 0; k < kStresses; ++k) {
      T* row = fine.out.row(k, y, z);
      for (int i = span.first; i < span.last; ++i) row[i] = contrast[i] != 0 ? row[i] : T(0);
    }
  });
  for_each_span([&](const RowSpan& span, int y, int z) {
    average_children(fine.out, start, row_box(c.box(), span, y, z), kToCoarse);
    for (int k = 0; k < kStresses; ++k) {
      T* row = defect.row(k, y, z);
      const T *residual = out.row(k, y, z), *restricted = start.row(k, y, z);
      for (int i = span.first; i < span.last; ++i) row[i] += restricted[i] - residual[i];
    }
  });
  start = p;
}

template <class T>
void StressField<T>::correct_from(const StressField& coarse) {
  for_each_span([&](const RowSpan& span, int y, int z) {
    add_linear(coarse.start, p, row_box(c.box(), span, y, z), kToFine);
  });
}

template <class T>
void StressField<T>::copy_from(const StressField& other) {
  copy_cells(other.p, p);
  copy_cells(other.before, before);
}

template class StressField<float>;
template class StressField<double>;

}  // namespace capstan
