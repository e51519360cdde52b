#include "solver/baseline/kernel_speed.hpp"

#include <algorithm>

#include "solver/baseline/best_time.hpp"
#include "solver/baseline/four_moment_lattice.hpp"
#include "solver/baseline/memory_bandwidth.hpp"
#include "solver/fluid/lattice/in_place_lattice.hpp"

namespace capstan {
namespace {

constexpr double kWallSpeed = 0.01;

/// The memory is measured before and after, since other programs may take their part of it.
template <class Lattice>
KernelSpeed measured(Lattice& lattice, Extent extent, std::size_t numbers_stored, std::size_t numbers_moved,
                     std::size_t size_of_number) {
  const std::size_t state = extent.cells() * numbers_stored * size_of_number;
  const double before = memory_bandwidth(state);
  const double seconds_of_two = best_time(1, [&] { lattice.step(), lattice.step(); });
  return {.updates = 2 * double(extent.cells()) / seconds_of_two,
          .bytes = double(numbers_moved * size_of_number),
          .bandwidth = std::max(before, memory_bandwidth(state))};
}

}  // namespace

template <class Real>
KernelSpeed kernel_speed(Baseline baseline, int n) {
  const Extent extent{n, n, n};
  if (baseline == Baseline::four_moments) {
    FourMomentLattice<Real> lattice(extent, kWallSpeed);
    return measured(lattice, extent, 2 * 4, 3 * 4, sizeof(Real));
  }
  InPlaceLattice<Real> lattice(extent, {.rates = kPaperRates, .nu_lu = 0.04, .wall_speed = kWallSpeed});
  lattice.set_couette();
  return measured(lattice, extent, d3q19::kQ, 2 * d3q19::kQ, sizeof(Real));
}

template KernelSpeed kernel_speed<float>(Baseline, int);
template KernelSpeed kernel_speed<double>(Baseline, int);

std::string_view word(Baseline baseline) {
  return baseline == Baseline::four_moments ? "four moments" : "19 populations";
}

}  // namespace capstan
