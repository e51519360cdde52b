#pragma once
// How fast the lattices' inner loops are, and how near to what the memory allows.
#include <string_view>

#include "solver/fluid/lbm/population_field.hpp"

namespace capstan {

enum class Kernel {
  nineteen_populations,  ///< InPlaceLattice with the paper's rates: the standard method that speed-ups are
                         ///< stated against
  four_moments,          ///< FourMomentLattice: that method at its own best
  composite,             ///< one smoothing sweep of the quasi-steady scheme, ghosts included
  composite_stress,      ///< the same where the viscosity differs
};
std::string_view to_string(Kernel kernel);

struct KernelSpeed {
  double updates;    ///< lattice updates a second
  double bytes;      ///< memory traffic of an update, arrays fetched to be overwritten included
  double bandwidth;  ///< bytes a second that the memory gave to an array as large, taking turns with it
  double share() const { return updates * bytes / bandwidth; }
};

/// On as many threads as OpenMP has; in about two seconds.
/// \tparam Real  float or double
template <class Real>
KernelSpeed kernel_speed(Kernel kernel, const Extent& cells);

extern template KernelSpeed kernel_speed<float>(Kernel, const Extent&);
extern template KernelSpeed kernel_speed<double>(Kernel, const Extent&);

}  // namespace capstan
