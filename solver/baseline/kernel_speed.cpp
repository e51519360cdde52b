#include "solver/baseline/kernel_speed.hpp"

#include <algorithm>

#include "solver/baseline/best_time.hpp"
#include "solver/baseline/four_moment_lattice.hpp"
#include "solver/baseline/memory_bandwidth.hpp"
#include "solver/fluid/quasisteady/composite_boxes.hpp"
#include "solver/fluid/quasisteady/moment_grid.hpp"
#include "solver/fluid/transient/in_place_lattice.hpp"

namespace capstan {
namespace {

constexpr double kWallSpeed = 0.01;

/// \param stored  numbers in memory per cell
/// \param moved   numbers that an update of a cell moves from and to memory
template <class Real, class Lattice>
KernelSpeed measured(Lattice& lattice, const IndexBox& box, int stored, int moved) {
  constexpr double kSpan = 2;  // seconds
  constexpr double kUpdatesPerTurn =
      2e6;  // so many that a small lattice stays in the caches during most of them
  const double cells = double(box.cells());
  const int steps = std::max(2, int(kUpdatesPerTurn / cells));
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

/// A grid of the quasisteady model, on a quarter of a domain that is twice as large.
template <class Real>
struct CompositeGrid {
  MomentGrid<Real> grid;

  CompositeGrid(const std::array<int, 3>& cells, bool has_ratio) : grid(make_grid(cells)) {
    if (!has_ratio) return;
    ScalarField ratio;
    ratio.reset(grid.box(), 4);
    grid.set_viscosity(ratio);
  }
  void step() { grid.relax(); }

  static MomentGrid<Real> make_grid(const std::array<int, 3>& cells) {
    constexpr double kDx = 0.1, kRe = 0.05;
    const auto [nx, ny, nz] = cells;
    const IndexBox box{{-nx / 2, 0, 0}, {nx / 2, ny, nz}};
    const IndexBox domain{{-nx, 0, 0}, {nx, 2 * ny, 2 * nz}};
    const Domain quarter{.cells = 2 * nx, .is_quarter = true, .is_uniform = false};
    return MomentGrid<Real>(box, domain, quarter.rules(), kDx, kRe, {0.9, 0.75});
  }
};

}  // namespace

template <class Real>
KernelSpeed kernel_speed(Kernel kernel, const std::array<int, 3>& cells) {
  const IndexBox box = box_from_zero(cells);
  switch (kernel) {
    case Kernel::nineteen_populations: {
      InPlaceLattice<Real> lattice(box, {.rates = kPaperRates, .nu_lu = 0.04, .wall_speed = kWallSpeed});
      lattice.set_couette();
      return measured<Real>(lattice, box, d3q19::kQ, 2 * d3q19::kQ);
    }
    case Kernel::four_moments: {
      FourMomentLattice<Real> lattice(box, kWallSpeed);
      return measured<Real>(lattice, box, 2 * kMoments, 3 * kMoments);
    }
    case Kernel::composite: {
      CompositeGrid<Real> lattice(cells, false);
      return measured<Real>(lattice, box, 3 * kMoments, 4 * kMoments);
    }
    case Kernel::composite_links:
      break;
  }
  CompositeGrid<Real> lattice(cells, true);
  return measured<Real>(lattice, box, 3 * kMoments + 1, 4 * kMoments + 1);
}

template KernelSpeed kernel_speed<float>(Kernel, const std::array<int, 3>&);
template KernelSpeed kernel_speed<double>(Kernel, const std::array<int, 3>&);

}  // namespace capstan
