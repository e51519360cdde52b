#include "solver/fluid/quasisteady/time_derivative.hpp"

#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

template <class T>
CAPSTAN_VECTOR_UNITS void subtract(const T* __restrict last, const T* __restrict before, T of_last,
                                   T of_before, int count, T* __restrict defect) {
  for (int i = 0; i < count; ++i) defect[i] -= of_last * last[i] + of_before * before[i];
}

}  // namespace

BackwardDifference backward_difference(std::span<const double> earlier, double t) {
  const double h = t - earlier.back();
  if (earlier.size() == 1) return {1 / h, -1 / h, 0};
  const double r = h / (earlier.back() - earlier.front());
  return {(1 + 2 * r) / (1 + r) / h, -(1 + r) / h, r * r / (1 + r) / h};
}

template <class T>
void subtract_known_part(const BackwardDifference& difference, const RowField<T>& last,
                         const RowField<T>& before, double inertia, RowField<T>& defect) {
  const T of_last = T(inertia * difference.last), of_before = T(inertia * difference.before);
  for_each_row(defect.box(), [&](int y, int z) {
    for (int k = kGx; k <= kGz; ++k)
      subtract(last.row(k, y, z), before.row(k, y, z), of_last, of_before, defect.box().size(0),
               defect.row(k, y, z));
  });
}

template void subtract_known_part(const BackwardDifference&, const RowField<float>&, const RowField<float>&,
                                  double, RowField<float>&);
template void subtract_known_part(const BackwardDifference&, const RowField<double>&, const RowField<double>&,
                                  double, RowField<double>&);

}  // namespace capstan
