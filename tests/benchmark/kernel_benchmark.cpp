// How near the lattices' sweeps come to the memory's own pace. Run on a quiet machine (and with 2 threads):
//   cmake --preset release -DCAPSTAN_BENCHMARKS=ON
//   cmake --build --preset release --target kernel_benchmark
//   OMP_NUM_THREADS=1 build/release/solver/kernel_benchmark
// `share` is the traffic of the sweep over that of scaling an array of the same size in place (`limit`); the
// two take turns. 19 populations move 38 numbers an update, four moments 12 with those that are fetched to be
// overwritten, a sweep of the composite 16, and 37 with stresses.
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
    state.SetIterationTime(double(n) * n * n / speed.updates);  // of one step
  }
  state.counters["updates/s"] = speed.updates;
  state.counters["limit B/s"] = speed.bandwidth;
  state.counters["share"] = speed.share();
}

/// 16^3 fits into a core's own cache, 128^3 into none.
void sizes(benchmark::internal::Benchmark* sweep) {
  sweep->RangeMultiplier(2)->Range(16, 128)->UseManualTime()->Iterations(1)->Unit(benchmark::kMicrosecond);
}
BENCHMARK_TEMPLATE(sweep, double, Kernel::nineteen_populations)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, float, Kernel::nineteen_populations)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, double, Kernel::four_moments)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, float, Kernel::four_moments)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, double, Kernel::composite)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, float, Kernel::composite)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, double, Kernel::composite_stress)->Apply(sizes);
BENCHMARK_TEMPLATE(sweep, float, Kernel::composite_stress)->Apply(sizes);

}  // namespace
}  // namespace capstan

BENCHMARK_MAIN();
