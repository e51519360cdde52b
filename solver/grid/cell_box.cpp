#include "solver/grid/cell_box.hpp"

#include <algorithm>
#include <cmath>

namespace capstan {

void add_scaled(double factor, const VectorBox& term, VectorBox& sum) {
  const int sum_lo = sum.lo()[0], term_lo = term.lo()[0];
  const int first = std::max(sum_lo, term_lo);
  const int end = std::min(sum_lo + sum.size()[0], term_lo + term.size()[0]);
  sum.for_each_row([&](int y, int z) {
    for (int c = 0; c < 3 && term.has_row(y, z); ++c)
      for (int x = first; x < end; ++x)
        sum.row(c, y, z)[x - sum_lo] += factor * term.row(c, y, z)[x - term_lo];
  });
}

double relative_difference(const VectorBox& u, const VectorBox& v) {
  const std::size_t cells = u.values().size() / 3;
  const auto length = [&](auto component) {
    return std::sqrt(std::pow(component(0), 2) + std::pow(component(1), 2) + std::pow(component(2), 2));
  };
  double change = 0, size = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    change += length([&](int c) { return u.values()[c * cells + i] - v.values()[c * cells + i]; });
    size += length([&](int c) { return u.values()[c * cells + i]; });
  }
  return change / size;
}

}  // namespace capstan
