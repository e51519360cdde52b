#include "solver/grid/cell_field.hpp"

#include <cmath>

#include "solver/grid/for_each_row.hpp"

namespace capstan {

ScalarField coarsened(const ScalarField& fine, double outside) {
  const IndexBox& box = fine.box();
  ScalarField coarse;
  coarse.reset(coarsened(box), outside);
  for_each_row_in_order(box, [&](int y, int z) {
    double* row = coarse.row(0, parent(y), parent(z)) - coarse.box().lo[0];
    for (int i = 0, x = box.lo[0]; x < box.hi[0]; ++i, ++x)
      row[parent(x)] += (fine.row(0, y, z)[i] - outside) / 8;
  });
  return coarse;
}

void add_scaled(double factor, const VectorField& term, VectorField& sum) {
  const IndexBox both = intersection(sum.box(), term.box());
  for_each_row_in_order(both, [&](int y, int z) {
    for (int c = 0; c < 3; ++c) {
      const double* from = term.row(c, y, z) + (both.lo[0] - term.box().lo[0]);
      double* to = sum.row(c, y, z) + (both.lo[0] - sum.box().lo[0]);
      for (int i = 0; i < both.size(0); ++i) to[i] += factor * from[i];
    }
  });
}

double relative_difference(const VectorField& u, const VectorField& v) {
  const std::size_t cells = u.values().size() / 3;
  const auto length = [&](auto component) {
    return std::sqrt(std::pow(component(0), 2) + std::pow(component(1), 2) + std::pow(component(2), 2));
  };
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    difference += length([&](int c) { return u.values()[c * cells + i] - v.values()[c * cells + i]; });
    size += length([&](int c) { return u.values()[c * cells + i]; });
  }
  return difference / size;
}

}  // namespace capstan
