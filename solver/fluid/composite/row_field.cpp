#include "solver/fluid/composite/row_field.hpp"

#include "solver/coupling/vector_units.hpp"

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

}  // namespace capstan
