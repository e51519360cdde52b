#include "runner/bench/kernel.hpp"

#include <omp.h>

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "runner/execute/exit_code.hpp"
#include "solver/baseline/kernel_speed.hpp"

namespace capstan {
namespace {

struct Row {
  Baseline baseline;
  bool single;  ///< precision
  int n;        ///< cells along an edge
  int threads;
  KernelSpeed speed;

  const char* precision() const { return single ? "float" : "double"; }
};

Row measure(Baseline baseline, bool single, int n, int threads) {
  omp_set_num_threads(threads);
  return {baseline, single, n, threads,
          single ? kernel_speed<float>(baseline, n) : kernel_speed<double>(baseline, n)};
}

template <class Visit>
void for_each_row(Visit visit) {
  for (const int threads : std::set{1, omp_get_max_threads()})
    for (const Baseline baseline : {Baseline::nineteen_populations, Baseline::four_moments})
      for (const bool single : {false, true})
        for (const int n : {32, 64, 128}) visit(measure(baseline, single, n, threads));
}

void print_row(const Row& row) {
  std::printf("| %-14s | %-6s | %4d^3 | %7d | %6.0f | %7.0f | %6.1f | %4.0f %% |\n",
              word(row.baseline).data(), row.precision(), row.n, row.threads, 1e-6 * row.speed.updates,
              row.speed.bytes, 1e-9 * row.speed.bandwidth, 100 * row.speed.share());
  std::fflush(stdout);
}

nlohmann::ordered_json to_json(const Row& row) {
  return {{"baseline", word(row.baseline)},
          {"precision", row.precision()},
          {"cells", row.n * row.n * row.n},
          {"threads", row.threads},
          {"updates_per_second", row.speed.updates},
          {"bytes_per_update", row.speed.bytes},
          {"memory_bytes_per_second", row.speed.bandwidth},
          {"share_of_roofline", row.speed.share()}};
}

}  // namespace

int bench_kernel(bool json) {
  if (json) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for_each_row([&](const Row& row) { rows.push_back(to_json(row)); });
    std::cout << rows.dump(2) << '\n';
    return kExitDone;
  }
  std::printf(
      "MLUPS: million lattice updates a second. Bytes: memory traffic of an update. Limit: what scaling an "
      "array of\n");
  std::printf("the same size in place gets, GB/s read and written. Best of a second each.\n\n");
  std::printf("| method         | number | cells  | threads |  MLUPS |   bytes |  limit |  share |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for_each_row(print_row);
  return kExitDone;
}

}  // namespace capstan
