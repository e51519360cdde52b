// How near the standard method's sweeps come to the memory's own pace. Run on a quiet machine:
//   cmake --preset release -DCAPSTAN_BENCHMARKS=ON && cmake --build --preset release --target
//   kernel_benchmark OMP_NUM_THREADS=1 build/release/solver/kernel_benchmark      (and with 2)
// `share` is the traffic of the sweep (bytes an update times updates) over that of scaling an array of the
// same size in place, measured beside it; 19 populations move 38 numbers an update, four moments 12 with
// those that are fetched to be overwritten.
#include <benchmark/benchmark.h>

#include <chrono>

#include "solver/baseline/four_moment_lattice.hpp"
#include "solver/baseline/memory_bandwidth.hpp"
#include "solver/fluid/lattice/in_place_lattice.hpp"

namespace capstan {
namespace {

template <class Lattice>
void step(benchmark::State& state, Lattice& lattice, int n, double bytes_stored, double bytes_moved) {
  const auto start = std::chrono::steady_clock::now();
  for (auto _ : state) lattice.step();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double cells = double(n) * n * n;
  state.counters["updates/s"] = benchmark::Counter(cells, benchmark::Counter::kIsIterationInvariantRate);
  const double bandwidth = memory_bandwidth(std::size_t(cells * bytes_stored));
  state.counters["share"] = cells * bytes_moved * double(state.iterations()) / seconds / bandwidth;
}

template <class Real>
void nineteen_populations(benchmark::State& state) {
  const int n = int(state.range(0));
  InPlaceLattice<Real> lattice({n, n, n}, {.rates = kPaperRates, .nu_lu = 0.04, .wall_speed = 0.01});
  lattice.set_couette();
  step(state, lattice, n, 19 * sizeof(Real), 2 * 19 * sizeof(Real));
}

template <class Real>
void four_moments(benchmark::State& state) {
  const int n = int(state.range(0));
  FourMomentLattice<Real> lattice({n, n, n}, 0.01);
  step(state, lattice, n, 2 * 4 * sizeof(Real), 3 * 4 * sizeof(Real));
}

// 16^3 fits into a core's own cache, 128^3 into none.
BENCHMARK(nineteen_populations<double>)->RangeMultiplier(2)->Range(16, 128)->UseRealTime();
BENCHMARK(nineteen_populations<float>)->RangeMultiplier(2)->Range(16, 128)->UseRealTime();
BENCHMARK(four_moments<double>)->RangeMultiplier(2)->Range(16, 256)->UseRealTime();
BENCHMARK(four_moments<float>)->RangeMultiplier(2)->Range(16, 256)->UseRealTime();

}  // namespace
}  // namespace capstan

BENCHMARK_MAIN();
