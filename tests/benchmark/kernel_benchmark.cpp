// Speed of the lattices' sweeps relative to the memory bandwidth. Run on a quiet machine, with one thread and
// with all:
//   cmake --preset release -DCAPSTAN_BENCHMARKS=ON
//   cmake --build --preset release --target kernel_benchmark
//   OMP_NUM_THREADS=1 build/release/tests/benchmark/kernel_benchmark
// `limit` is the memory traffic of scaling an array of the same size in place, in bytes a second; `share` is
// the traffic of the sweep over this limit. The two are measured in turns. An update of a cell moves 38
// numbers with 19 populations, 12 with four moments (including those that are fetched only to be
// overwritten), 16 in a sweep of the composite grid, and 17 where the viscosity varies.
#include <benchmark/benchmark.h>

#include "solver/baseline/kernel_speed.hpp"

namespace capstan {
namespace {

template <class Real, Kernel kernel>
void sweep(benchmark::State& state) {
  const int n = int(state.range(0));
  KernelSpeed speed{};
  for (auto _ : state) {
    speed = kernel_speed<Real>(kernel, {n, n, n});
    state.SetIterationTime(double(n) * n * n / speed.updates);  // time of one step
  }
  state.counters["updates/s"] = speed.updates;
  state.counters["limit B/s"] = speed.bandwidth;
  state.counters["share"] = speed.share();
}

/// 16^3 cells fit into a core's own cache, 128^3 into no cache.
void sizes(benchmark::internal::Benchmark* sweep) {
  sweep->RangeMultiplier(2)->Range(16, 128)->UseManualTime()->Iterations(1)->Unit(benchmark::kMicrosecond);
}
BENCHMARK_TEMPLATE(sweep, double, Kernel::nineteen_populations)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, float, Kernel::nineteen_populations)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, double, Kernel::four_moments)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, float, Kernel::four_moments)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, double, Kernel::composite)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, float, Kernel::composite)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, double, Kernel::composite_links)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, float, Kernel::composite_links)->Apply(sizes);

}  // namespace
}  // namespace capstan

BENCHMARK_MAIN();
