#include "solver/baseline/kernel_speed.hpp"

#include <algorithm>

#include "solver/baseline/best_time.hpp"
#include "solver/baseline/four_moment_lattice.hpp"
#include "solver/baseline/memory_bandwidth.hpp"
#include "solver/fluid/quasisteady/grid.hpp"
#include "solver/fluid/quasisteady/layout.hpp"
#include "solver/fluid/transient/in_place_lattice.hpp"

namespace capstan {
namespace {

constexpr double kWallSpeed = 0.01;

/// \param stored, moved  numbers of a cell in memory, and to and from it by an update
template <class Real, class Lattice>
KernelSpeed measured(Lattice& lattice, const Extent& extent, int stored, int moved) {
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

/// A grid of the composite in the quarter of a domain twice as large.
template <class Real>
struct CompositeGrid {
  Grid<Real> grid;

  CompositeGrid(const Extent& cells, bool has_stress) : grid(made(cells, has_stress)) {
    if (!has_stress) return;
    ScalarBox viscosity;
    viscosity.reset(grid.box().lo, grid.box().sizes(), 4);
    grid.set_viscosity(viscosity);
  }
  void step() { grid.relax(); }

  static Grid<Real> made(const Extent& cells, bool has_stress) {
    constexpr double kDx = 0.1, kRe = 0.05;
    const IndexBox box{{-cells.nx / 2, 0, 0}, {cells.nx / 2, cells.ny, cells.nz}};
    const IndexBox domain{{-cells.nx, 0, 0}, {cells.nx, 2 * cells.ny, 2 * cells.nz}};
    const Domain quarter{.cells = 2 * cells.nx, .is_quarter = true, .is_uniform = false};
    return Grid<Real>(box, domain, quarter.rules(), kDx, kRe, has_stress, {{0.9, 0.75}, 0.5});
  }
};

}  // namespace

template <class Real>
KernelSpeed kernel_speed(Kernel kernel, const Extent& cells) {
  constexpr int kOfAll = int(kMoments) + int(kStresses), kContrast = 1;
  switch (kernel) {
    case Kernel::nineteen_populations: {
      InPlaceLattice<Real> lattice(cells, {.rates = kPaperRates, .nu_lu = 0.04, .wall_speed = kWallSpeed});
      lattice.set_couette();
      return measured<Real>(lattice, cells, d3q19::kQ, 2 * d3q19::kQ);
    }
    case Kernel::four_moments: {
      FourMomentLattice<Real> lattice(cells, kWallSpeed);
      return measured<Real>(lattice, cells, 2 * kMoments, 3 * kMoments);
    }
    case Kernel::composite: {
      CompositeGrid<Real> lattice(cells, false);
      return measured<Real>(lattice, cells, 3 * kMoments, 4 * kMoments);
    }
    case Kernel::composite_stress:
      break;
  }
  CompositeGrid<Real> lattice(cells, true);
  return measured<Real>(lattice, cells, 3 * kOfAll + kContrast, 4 * kOfAll + kContrast);
}

template KernelSpeed kernel_speed<float>(Kernel, const Extent&);
template KernelSpeed kernel_speed<double>(Kernel, const Extent&);

std::string_view to_string(Kernel kernel) {
  switch (kernel) {
    case Kernel::nineteen_populations:
      return "19 populations";
    case Kernel::four_moments:
      return "four moments";
    case Kernel::composite:
      return "composite";
    case Kernel::composite_stress:
      break;
  }
  return "with stresses";
}

}  // namespace capstan
