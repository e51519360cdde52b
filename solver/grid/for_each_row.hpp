#pragma once
// Loops over the rows of cells along x of a box.
#include <omp.h>

#include "solver/grid/index_box.hpp"

namespace capstan {

/// Calls visit(y, z) for all rows of a box, one after the other: z is the outer loop.
template <class Visit>
void for_each_row_in_order(const IndexBox& box, Visit visit) {
  for (int z = box.lo[2]; z < box.hi[2]; ++z)
    for (int y = box.lo[1]; y < box.hi[1]; ++y) visit(y, z);
}

/// Calls visit(y, z) for all rows of a box, on all threads of OpenMP if the box is large enough. The visits
/// must be independent of each other: then the result does not depend on the number of threads.
template <class Visit>
void for_each_row(const IndexBox& box, Visit visit) {
  constexpr long kMinCellsForThreads =
      8000;  // some microseconds of work, more than starting the threads costs
  if (omp_get_max_threads() == 1 || box.cells() < kMinCellsForThreads)
    return for_each_row_in_order(box, visit);
#pragma omp parallel for collapse(2) schedule(static)
  for (int z = box.lo[2]; z < box.hi[2]; ++z)
    for (int y = box.lo[1]; y < box.hi[1]; ++y) visit(y, z);
}

}  // namespace capstan
