#pragma once
// Rounding error of the flow: a lower bound for tolerances and error estimates.
#include "solver/case/case.hpp"

namespace capstan {

/// Relative rounding error of the vertex velocities. Measured by translating a capsule: 1e-7 to 1e-6 with
/// boundary integrals, whose sums are in single precision (it grows with V); on a lattice in single precision
/// the multigrid cycles stall between 1e-7 and 1e-8.
inline double flow_rounding(const Case& c) {
  const bool is_double = c.has_grid() && !(c.has_precision() && c.fidelity.precision == Precision::single);
  return is_double ? 1e-12 : 1e-6;
}

}  // namespace capstan
