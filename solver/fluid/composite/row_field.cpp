#include "solver/fluid/composite/row_field.hpp"

#include "solver/coupling/vector_units.hpp"

namespace capstan {
namespace {

template <class T>
CAPSTAN_VECTOR_UNITS void extrapolate(T* __restrict now, T* __restrict before, std::size_t count, T weight) {
  for (std::size_t i = 0; i < count; ++i) {
    const T at_this_time = now[i];
    now[i] += weight * (at_this_time - before[i]);
    before[i] = at_this_time;
  }
}

template <class T>
CAPSTAN_VECTOR_UNITS void subtract(const T* __restrict now, T* __restrict start, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) start[i] = now[i] - start[i];
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
