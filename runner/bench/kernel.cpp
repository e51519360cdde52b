#include "runner/bench/kernel.hpp"

#include <omp.h>

#include <cmath>
#include <set>

#include "runner/bench/bench_table.hpp"
#include "runner/execute/exit_code.hpp"
#include "solver/baseline/kernel_speed.hpp"

namespace capstan {
namespace {

enum class Number { float32, float64 };

nlohmann::ordered_json measured_row(Baseline baseline, Number number, int n, int threads) {
  omp_set_num_threads(threads);
  const KernelSpeed speed =
      number == Number::float32 ? kernel_speed<float>(baseline, n) : kernel_speed<double>(baseline, n);
  return {{"method", word(baseline)},
          {"number", number == Number::float32 ? "float" : "double"},
          {"cells an edge", n},
          {"threads", threads},
          {"MLUPS", std::round(1e-6 * speed.updates)},
          {"bytes an update", speed.bytes},
          {"limit, GB/s", std::round(1e-8 * speed.bandwidth) / 10},
          {"share, %", std::round(100 * speed.share())}};
}

}  // namespace

int bench_kernel(bool json) {
  nlohmann::ordered_json rows;
  for (const int threads : std::set{1, omp_get_max_threads()})
    for (const Baseline baseline : {Baseline::nineteen_populations, Baseline::four_moments})
      for (const Number number : {Number::float64, Number::float32})
        for (const int n : {32, 64, 128}) rows.push_back(measured_row(baseline, number, n, threads));
  print_rows(
      "Million lattice updates a second (MLUPS), and their memory traffic as a share of what scaling an "
      "array in "
      "place gets (limit: read and written)",
      rows, json);
  return kExitDone;
}

}  // namespace capstan
