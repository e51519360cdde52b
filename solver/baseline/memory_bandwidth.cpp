#include "solver/baseline/memory_bandwidth.hpp"

#include <algorithm>

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

CAPSTAN_VECTOR_UNITS void scale_part(double* numbers, std::size_t count) {
  constexpr double kFactor = 0.99999999;  // so near to 1 that the numbers do not become denormal
  for (std::size_t i = 0; i < count; ++i) numbers[i] *= kFactor;
}

}  // namespace

void ScaledArray::scale() {
  constexpr std::size_t kPart = 4096;
#pragma omp parallel for schedule(static)
  for (std::size_t first = 0; first < numbers_.size(); first += kPart)
    scale_part(numbers_.data() + first, std::min(kPart, numbers_.size() - first));
}

}  // namespace capstan
