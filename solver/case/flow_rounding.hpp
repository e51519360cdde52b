#pragma once
// How exact the numbers of a flow can be: no tolerance reaches below, and no estimate of an error may.
#include "solver/case/case.hpp"

namespace capstan {

/// Relative error of the vertices' velocities by rounding. Measured by moving a capsule in the flow: 1e-7 to
/// 1e-6 where the sums of boundary integrals are of single precision (the more, the larger V); on a lattice
/// in single precision the cycles stall between 1e-7 and 1e-8.
inline double flow_rounding(const Case& c) {
  const bool is_double = c.has_grid() && !(c.has_precision() && c.fidelity.precision == Precision::single);
  return is_double ? 1e-12 : 1e-6;
}

}  // namespace capstan
