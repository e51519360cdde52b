#pragma once
// The bandwidth of the memory, which limits the speed of any sweep over arrays.
#include <cstddef>
#include <vector>

#include "solver/grid/huge_pages.hpp"

namespace capstan {

/// An array that is multiplied in place by a factor, on all threads of OpenMP. Every byte is read once and
/// written once: the same memory traffic as that of an InPlaceLattice of the same size, with next to no
/// arithmetic.
class ScaledArray {
 public:
  explicit ScaledArray(std::size_t bytes) : numbers_(bytes / sizeof(double), 1.0) {}

  void scale();
  /// Bytes read plus bytes written by one call of scale().
  double bytes_moved() const { return 2 * double(numbers_.size() * sizeof(double)); }

 private:
  std::vector<double, HugePageAllocator<double>> numbers_;
};

}  // namespace capstan
