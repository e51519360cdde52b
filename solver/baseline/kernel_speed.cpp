#include "solver/baseline/kernel_speed.hpp"

#include <algorithm>

#include "solver/baseline/best_time.hpp"
#include "solver/baseline/four_moment_lattice.hpp"
#include "solver/baseline/memory_bandwidth.hpp"
#include "solver/fluid/lattice/in_place_lattice.hpp"

namespace capstan {
namespace {

constexpr double kWallSpeed = 0.01;

/// \param stored, moved  numbers of a cell in memory, and to and from it by an update
template <class Real, class Lattice>
KernelSpeed measured(Lattice& lattice, Extent extent, int stored, int moved) {
  constexpr double kSpan = 2,
                   kUpdatesOfATurn = 2e6;  // so that a small lattice is in the caches for most of its turn
  const double cells = double(extent.cells());
  const int steps = std::max(2, int(kUpdatesOfATurn / cells));
  ScaledArray array(std::size_t(cells * stored * sizeof(Real)));
  const auto repeated = [steps](auto work) {
    return [=] {
      for (int n = 0; n < steps; ++n) work();
    };
  };
  const auto [stepping, scaling] =
      best_times(kSpan, repeated([&] { lattice.step(); }), repeated([&] { array.scale(); }));
  return {.updates = steps * cells / stepping,
          .bytes = double(moved * sizeof(Real)),
          .bandwidth = steps * array.bytes_moved() / scaling};
}

}  // namespace

template <class Real>
KernelSpeed kernel_speed(Baseline baseline, int n) {
  const Extent extent{n, n, n};
  if (baseline == Baseline::four_moments) {
    FourMomentLattice<Real> lattice(extent, kWallSpeed);
    return measured<Real>(lattice, extent, 2 * 4, 3 * 4);
  }
  InPlaceLattice<Real> lattice(extent, {.rates = kPaperRates, .nu_lu = 0.04, .wall_speed = kWallSpeed});
  lattice.set_couette();
  return measured<Real>(lattice, extent, d3q19::kQ, 2 * d3q19::kQ);
}

template KernelSpeed kernel_speed<float>(Baseline, int);
template KernelSpeed kernel_speed<double>(Baseline, int);

std::string_view word(Baseline baseline) {
  return baseline == Baseline::four_moments ? "four moments" : "19 populations";
}

}  // namespace capstan
