#pragma once
// What the memory can give: the limit of a sweep that does nothing else.
#include <cstddef>
#include <vector>

#include "solver/grid/huge_pages.hpp"

namespace capstan {

/// An array that is scaled in place, on as many threads as OpenMP has: every byte is read once and written
/// once and nothing is fetched only to be overwritten. The traffic of an InPlaceLattice of the same size,
/// without its work.
class ScaledArray {
 public:
  explicit ScaledArray(std::size_t bytes) : numbers_(bytes / sizeof(double), 1.0) {}

  void scale();
  /// By one scaling, read and written.
  double bytes_moved() const { return 2 * double(numbers_.size() * sizeof(double)); }

 private:
  std::vector<double, HugePageAllocator<double>> numbers_;
};

}  // namespace capstan
