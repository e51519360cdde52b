#pragma once
// How fast the standard method is, and how near to what the memory allows.
#include <string_view>

namespace capstan {

/// The two standard methods that speed-ups are stated against.
enum class Baseline {
  nineteen_populations,  ///< InPlaceLattice with the paper's rates
  four_moments,          ///< FourMomentLattice: the method at its own best
};
std::string_view word(Baseline baseline);

struct KernelSpeed {
  double updates;    ///< lattice updates a second
  double bytes;      ///< memory traffic of an update, arrays fetched to be overwritten included
  double bandwidth;  ///< bytes a second that the memory gave to an array as large, taking turns with it
  double share() const { return updates * bytes / bandwidth; }
};

/// Of a cube of n^3 cells, on as many threads as OpenMP has; in about two seconds.
/// \tparam Real  float or double
template <class Real>
KernelSpeed kernel_speed(Baseline baseline, int n);

extern template KernelSpeed kernel_speed<float>(Baseline, int);
extern template KernelSpeed kernel_speed<double>(Baseline, int);

}  // namespace capstan
