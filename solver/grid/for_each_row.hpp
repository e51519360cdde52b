#pragma once
// Work row by row, on as many threads as there are where it pays.
#include <omp.h>

#include "solver/grid/index_box.hpp"

namespace capstan {

/// visit(y, z) for all rows of a box. Rows must be independent of each other: then the result does not depend
/// on the number of threads.
template <class Visit>
void for_each_row(const IndexBox& box, Visit visit) {
  constexpr long kWorthThreads = 8000;  // cells: some microseconds of work
  if (omp_get_max_threads() == 1 || box.cells() < kWorthThreads) {
    for (int z = box.lo[2]; z < box.hi[2]; ++z)
      for (int y = box.lo[1]; y < box.hi[1]; ++y) visit(y, z);
    return;
  }
#pragma omp parallel for collapse(2) schedule(static)
  for (int z = box.lo[2]; z < box.hi[2]; ++z)
    for (int y = box.lo[1]; y < box.hi[1]; ++y) visit(y, z);
}

}  // namespace capstan
