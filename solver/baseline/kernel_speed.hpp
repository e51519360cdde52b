#pragma once
// The speed of the lattices' inner loops, and its ratio to the limit set by the memory bandwidth.
#include <array>

#include "solver/case/words.hpp"

namespace capstan {

enum class Kernel {
  nineteen_populations,  ///< InPlaceLattice with the paper's rates: the standard method, to which speed-ups
                         ///< are related
  four_moments,          ///< FourMomentLattice: the standard method with its best parameters
  composite,             ///< one smoothing sweep of the quasisteady model, ghosts included
  composite_links,       ///< the same where the viscosity varies from cell to cell
};
template <>
inline constexpr auto kWords<Kernel> =
    std::to_array<Word<Kernel>>({{Kernel::nineteen_populations, "19 populations"},
                                 {Kernel::four_moments, "four moments"},
                                 {Kernel::composite, "composite"},
                                 {Kernel::composite_links, "varying viscosity"}});

struct KernelSpeed {
  double updates;  ///< cells updated per second
  double bytes;  ///< memory traffic of an update of a cell; a write to memory that is not in the cache counts
                 ///< twice
  double bandwidth;  ///< bytes per second measured in turns with ScaledArray, on an array of the same size
  /// Memory traffic per second over the bandwidth.
  double share() const { return updates * bytes / bandwidth; }
};

/// Measures for about two seconds, on all threads of OpenMP.
/// \tparam Real  float or double
/// \param cells  along x, y, z
template <class Real>
KernelSpeed kernel_speed(Kernel kernel, const std::array<int, 3>& cells);

extern template KernelSpeed kernel_speed<float>(Kernel, const std::array<int, 3>&);
extern template KernelSpeed kernel_speed<double>(Kernel, const std::array<int, 3>&);

}  // namespace capstan
