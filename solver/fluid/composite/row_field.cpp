#include "solver/fluid/composite/row_field.hpp"

#include "solver/coupling/vector_units.hpp"

namespace capstan {
namespace {

template <class T>
[[gnu::always_inline]] inline void extrapolate_all(T* __restrict now, T* __restrict before, std::size_t count,
                                                   T weight) {
  for (std::size_t i = 0; i < count; ++i) {
    const T at_this_time = now[i];
    now[i] += weight * (at_this_time - before[i]);
    before[i] = at_this_time;
  }
}
CAPSTAN_VECTOR_UNITS void extrapolate(float* now, float* before, std::size_t count, float weight) {
  extrapolate_all(now, before, count, weight);
}
CAPSTAN_VECTOR_UNITS void extrapolate(double* now, double* before, std::size_t count, double weight) {
  extrapolate_all(now, before, count, weight);
}

template <class T>
[[gnu::always_inline]] inline void subtract_all(const T* __restrict now, T* __restrict start,
                                                std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) start[i] = now[i] - start[i];
}
CAPSTAN_VECTOR_UNITS void subtract(const float* now, float* start, std::size_t count) {
  subtract_all(now, start, count);
}
CAPSTAN_VECTOR_UNITS void subtract(const double* now, double* start, std::size_t count) {
  subtract_all(now, start, count);
}

}  // namespace

template <class T>
void extrapolate_field(RowField<T>& now, RowField<T>& before, double weight) {
  extrapolate(now.data().data(), before.data().data(), now.data().size(), T(weight));
}

template <class T>
void take_difference(const RowField<T>& now, RowField<T>& start) {
  subtract(now.data().data(), start.data().data(), now.data().size());
}

template void extrapolate_field(RowField<float>&, RowField<float>&, double);
template void extrapolate_field(RowField<double>&, RowField<double>&, double);
template void take_difference(const RowField<float>&, RowField<float>&);
template void take_difference(const RowField<double>&, RowField<double>&);

}  // namespace capstan
