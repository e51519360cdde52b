#pragma once
// Rows of cells with random numbers, for tests of sweeps.
#include <algorithm>
#include <cmath>
#include <random>

#include "solver/grid/row_field.hpp"

namespace capstan::testing {

/// Uniform random numbers between low and high, in ghosts, too.
template <class T>
RowField<T> random_rows(const IndexBox& box, int components, unsigned seed, T low = -1, T high = 1) {
  RowField<T> field(box, components);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<T> uniform(low, high);
  for (T& number : field.data()) number = uniform(generator);
  return field;
}

/// Largest difference of two fields over one box, in its cells.
template <class T>
double largest_difference(const RowField<T>& a, const RowField<T>& b) {
  double largest = 0;
  for_each_row_in_order(a.box(), [&](int y, int z) {
    for (int k = 0; k < a.components(); ++k)
      for (int x = 0; x < a.box().size(0); ++x)
        largest = std::max(largest, std::abs(double(a.row(k, y, z)[x]) - double(b.row(k, y, z)[x])));
  });
  return largest;
}

}  // namespace capstan::testing
