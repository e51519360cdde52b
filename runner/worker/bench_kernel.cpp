#include "runner/worker/benchmarks.hpp"

#include <omp.h>

#include <array>
#include <cmath>
#include <set>

#include "runner/worker/bench_report.hpp"
#include "solver/baseline/kernel_speed.hpp"
#include "solver/case/fidelity.hpp"

namespace capstan {
namespace {

/// Cubes that fit into a core's own caches, into the shared cache and into no cache; the fine grid around a
/// red cell.
constexpr std::array<int, 3> kSizes[] = {{32, 32, 32}, {64, 64, 64}, {128, 128, 128}, {44, 22, 24}};

nlohmann::ordered_json measured_row(Kernel kernel, Precision precision, const std::array<int, 3>& cells,
                                    int threads) {
  omp_set_num_threads(threads);
  const KernelSpeed speed = precision == Precision::single ? kernel_speed<float>(kernel, cells)
                                                           : kernel_speed<double>(kernel, cells);
  return {{"method", to_string(kernel)},
          {"number", to_string(precision)},
          {"cells",
           std::to_string(cells[0]) + " x " + std::to_string(cells[1]) + " x " + std::to_string(cells[2])},
          {"threads", threads},
          {"MLUPS", std::round(1e-6 * speed.updates)},
          {"bytes an update", speed.bytes},
          {"limit, GB/s", std::round(1e-8 * speed.bandwidth) / 10},
          {"share, %", std::round(100 * speed.share())}};
}

}  // namespace

void bench_kernel(BenchReport& report) {
  using enum Kernel;
  nlohmann::ordered_json rows;
  for (const int threads : std::set{1, omp_get_max_threads()})
    for (const Kernel kernel : {nineteen_populations, four_moments, composite, composite_links})
      for (const Precision precision : {Precision::double_, Precision::single})
        for (const std::array<int, 3>& cells : kSizes)
          rows.push_back(measured_row(kernel, precision, cells, threads));
  report.add(
      "Million lattice updates a second (MLUPS), and their memory traffic as a share of what scaling an "
      "array in "
      "place gets (limit: read and written)",
      rows);
}

}  // namespace capstan
