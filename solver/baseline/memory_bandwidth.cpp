#include "solver/baseline/memory_bandwidth.hpp"

#include <algorithm>
#include <vector>

#include "solver/baseline/best_time.hpp"
#include "solver/fluid/lattice/huge_pages.hpp"

namespace capstan {
namespace {

__attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"))) void scale(double* numbers,
                                                                                         std::size_t count) {
  constexpr double kFactor = 0.99999999;  // far from denormal numbers for as long as anyone measures
  for (std::size_t i = 0; i < count; ++i) numbers[i] *= kFactor;
}

}  // namespace

double memory_bandwidth(std::size_t bytes) {
  constexpr std::size_t kPart = 4096;
  std::vector<double, HugePageAllocator<double>> numbers(bytes / sizeof(double), 1.0);
  const double seconds = best_time(0.5, [&] {
#pragma omp parallel for schedule(static)
    for (std::size_t first = 0; first < numbers.size(); first += kPart)
      scale(numbers.data() + first, std::min(kPart, numbers.size() - first));
  });
  return 2 * double(numbers.size() * sizeof(double)) / seconds;
}

}  // namespace capstan
