#pragma once
#include "solver/fluid/lbm/d3q19.hpp"
#include "solver/grid/row_field.hpp"

namespace capstan::testing {

/// Density (deviation from 1) and momentum (without half of the force) of the populations of one cell.
struct Macroscopic {
  double rho, jx, jy, jz;
};
inline Macroscopic macroscopic(const RowField<double>& f, int x, int y, int z) {
  Macroscopic m{};
  for (int q = 0; q < d3q19::kQ; ++q) {
    const double value = f.row(q, y, z)[x];
    m.rho += value;
    m.jx += d3q19::e[q].x * value;
    m.jy += d3q19::e[q].y * value;
    m.jz += d3q19::e[q].z * value;
  }
  return m;
}

}  // namespace capstan::testing
