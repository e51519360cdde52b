#include "solver/grid/row_field.hpp"

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

template <class T>
CAPSTAN_VECTOR_UNITS void extrapolate_numbers(T* __restrict now, T* __restrict before, std::size_t count,
                                              T weight) {
  for (std::size_t i = 0; i < count; ++i) {
    const T at_this_time = now[i];
    now[i] += weight * (at_this_time - before[i]);
    before[i] = at_this_time;
  }
}

template <class T>
CAPSTAN_VECTOR_UNITS void subtract_numbers(const T* __restrict now, T* __restrict start, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) start[i] = now[i] - start[i];
}

template <class T>
CAPSTAN_VECTOR_UNITS void add_numbers(const T* __restrict a, const T* __restrict b, T* __restrict sum,
                                      int count) {
  for (int i = 0; i < count; ++i) sum[i] += a[i] - b[i];
}

}  // namespace

void extrapolate(std::span<float> now, std::span<float> before, double weight) {
  extrapolate_numbers(now.data(), before.data(), now.size(), float(weight));
}
void extrapolate(std::span<double> now, std::span<double> before, double weight) {
  extrapolate_numbers(now.data(), before.data(), now.size(), weight);
}

void take_difference(std::span<const float> now, std::span<float> start) {
  subtract_numbers(now.data(), start.data(), now.size());
}
void take_difference(std::span<const double> now, std::span<double> start) {
  subtract_numbers(now.data(), start.data(), now.size());
}

template <class T>
void add_difference(const RowField<T>& a, const RowField<T>& b, RowField<T>& sum, const IndexBox& region) {
  const int first = region.lo[0] - sum.box().lo[0];
  for_each_row(region, [&](int y, int z) {
    for (int k = 0; k < sum.components(); ++k)
      add_numbers(a.row(k, y, z) + first, b.row(k, y, z) + first, sum.row(k, y, z) + first, region.size(0));
  });
}
template void add_difference(const RowField<float>&, const RowField<float>&, RowField<float>&,
                             const IndexBox&);
template void add_difference(const RowField<double>&, const RowField<double>&, RowField<double>&,
                             const IndexBox&);

}  // namespace capstan
