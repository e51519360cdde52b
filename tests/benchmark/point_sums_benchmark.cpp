// Speed of the sums over all pairs of nodes relative to the peak of the processor. Run on a quiet machine:
//   cmake --preset release -DCAPSTAN_BENCHMARKS=ON
//   cmake --build --preset release --target point_sums_benchmark
//   build/release/tests/benchmark/point_sums_benchmark --benchmark_repetitions=9
// Instructions for one vector of pairs, as g++ 12 compiles the loops for AVX-512 and AVX2:
//                multiplications   of them fused   additions   estimates of 1/sqrt   flops a pair
//   Stokeslets                18              11           3                     1             33
//   stresslets                21              10           6                     1             38
// The peak of each mix is measured with the same instructions on registers, without dependences between them.
#include <benchmark/benchmark.h>
#include <immintrin.h>

#include <utility>

#include "solver/fluid/stokes/point_sums.hpp"

namespace capstan {
namespace {

// The widest vectors of this machine (-march=native): those that the loops use there.
#if defined(__AVX512F__)
using Vector = __m512;
Vector all(float value) { return _mm512_set1_ps(value); }
inline void estimate_root(Vector& root) { asm volatile("vrsqrt14ps %0, %0" : "+v"(root)); }
#else
using Vector = __m256;
Vector all(float value) { return _mm256_set1_ps(value); }
inline void estimate_root(Vector& root) { asm volatile("vrsqrtps %0, %0" : "+x"(root)); }
#endif
constexpr int kLanes = sizeof(Vector) / sizeof(float);

PointArray random_points(int count) {
  PointArray points;
  points.assign(Eigen::Matrix3Xd::Random(3, count));
  return points;
}

void report_pairs(benchmark::State& state, double pairs_an_iteration) {
  state.counters["pairs/s"] =
      benchmark::Counter(pairs_an_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

void stokeslets(benchmark::State& state) {
  const int count = int(state.range(0));
  const PointArray points = random_points(count), strengths = random_points(count);
  for (auto _ : state)
    for (int n = 0; n < count; ++n)
      benchmark::DoNotOptimize(
          sum_stokeslets(points, strengths, {points.x()[n], points.y()[n], points.z()[n]}));
  report_pairs(state, double(count) * count);
}
BENCHMARK(stokeslets)->Arg(642)->Arg(2562)->Arg(10242);

void stresslets(benchmark::State& state) {
  const int count = int(state.range(0));
  const PointArray points = random_points(count), areas = random_points(count),
                   velocities = random_points(count);
  for (auto _ : state)
    for (int n = 0; n < count; ++n) {
      const Eigen::Vector3f x0{points.x()[n], points.y()[n], points.z()[n]};
      benchmark::DoNotOptimize(sum_stresslets(points, areas, velocities, x0, x0));
    }
  report_pairs(state, double(count) * count);
}
BENCHMARK(stresslets)->Arg(642)->Arg(2562)->Arg(10242);

// In assembler, so that the compiler cannot evaluate it at compile time.
inline void multiply_add(Vector& product, Vector factor, Vector term) {
  asm volatile("vfmadd213ps %2, %1, %0" : "+v"(product) : "v"(factor), "v"(term));
}
inline void add(Vector& sum, Vector term) { asm volatile("vaddps %1, %0, %0" : "+v"(sum) : "v"(term)); }

/// The instructions for two vectors of pairs, on enough independent chains to hide the latency of each
/// instruction.
template <size_t... multiplication, size_t... addition>
void two_vectors(Vector (&products)[9], Vector (&sums)[3], Vector (&roots)[2],
                 std::index_sequence<multiplication...>, std::index_sequence<addition...>) {
  const Vector factor = all(0.999f), term = all(0.001f);
  (multiply_add(products[multiplication % 9], factor, term), ...);
  (add(sums[addition % 3], term), ...);
  for (Vector& root : roots) estimate_root(root);
}

template <size_t multiplications, size_t additions>
void mix(benchmark::State& state) {
  constexpr int kVectors = 1000;
  Vector products[9], sums[3], roots[] = {all(1.5f), all(1.5f)};
  for (Vector& product : products) product = all(1.f);
  for (Vector& sum : sums) sum = all(1.f);
  for (auto _ : state)
    for (int n = 0; n < kVectors; n += 2)
      two_vectors(products, sums, roots, std::make_index_sequence<2 * multiplications>(),
                  std::make_index_sequence<2 * additions>());
  report_pairs(state, double(kVectors) * kLanes);
}
void peak_of_stokeslets(benchmark::State& state) { mix<18, 3>(state); }
void peak_of_stresslets(benchmark::State& state) { mix<21, 6>(state); }
BENCHMARK(peak_of_stokeslets);
BENCHMARK(peak_of_stresslets);

}  // namespace
}  // namespace capstan

BENCHMARK_MAIN();
