// Compiled three times, for CAPSTAN_UNIT = x86_64, x86_64_v3 and x86_64_v4. Inline functions of other headers
// must not be used here: the linker would keep one copy of each, possibly one that needs AVX-512. Sums may be
// reordered (-ffast-math). Results do not depend on the number of threads, but differ in the last bits
// between the instruction sets.
#include "solver/fluid/stokes/point_loops.hpp"

#include <immintrin.h>

namespace capstan {
namespace {

// An estimate of 1/sqrt(a), accurate to 12 or 14 bits; 0 for a = 0.
#if defined(__AVX512F__)
using Vector = __m512;
Vector estimate_inverse_root(Vector a) {
  return _mm512_maskz_rsqrt14_ps(_mm512_cmp_ps_mask(a, Vector{}, _CMP_GT_OQ), a);
}
#elif defined(__AVX2__)
using Vector = __m256;
Vector estimate_inverse_root(Vector a) { return a > 0 ? _mm256_rsqrt_ps(a) : Vector{}; }
#else
using Vector = __m128;
Vector estimate_inverse_root(Vector a) { return a > 0 ? _mm_rsqrt_ps(a) : Vector{}; }
#endif
constexpr int kLanes = sizeof(Vector) / sizeof(float);

Vector load(const float* numbers) {
  Vector lanes;
  __builtin_memcpy(&lanes, numbers, sizeof lanes);
  return lanes;
}

float sum_of_lanes(Vector lanes) {
  float sum = 0;
  for (int lane = 0; lane < kLanes; ++lane) sum += lanes[lane];
  return sum;
}

/// 1/r from r^2, the estimate improved by one step of Newton's method; 0 for r = 0.
Vector inverse_root(Vector r2) {
  const Vector estimate = estimate_inverse_root(r2);
  return estimate * (1.5f - 0.5f * r2 * estimate * estimate);
}

void stokeslets(int count, Components at, Components force, const float* x0, float* sum) {
  Vector ux{}, uy{}, uz{};
  for (int n = 0; n < count; n += kLanes) {
    const Vector x = load(at.x + n) - x0[0], y = load(at.y + n) - x0[1], z = load(at.z + n) - x0[2];
    const Vector fx = load(force.x + n), fy = load(force.y + n), fz = load(force.z + n);
    const Vector inverse = inverse_root(x * x + y * y + z * z);
    const Vector along = (x * fx + y * fy + z * fz) * (inverse * inverse);
    ux += inverse * (fx + along * x);
    uy += inverse * (fy + along * y);
    uz += inverse * (fz + along * z);
  }
  sum[0] = sum_of_lanes(ux), sum[1] = sum_of_lanes(uy), sum[2] = sum_of_lanes(uz);
}

void stresslets(int count, Components at, Components area, Components u, const float* x0, const float* u0,
                float* sum) {
  Vector ux{}, uy{}, uz{};
  for (int n = 0; n < count; n += kLanes) {
    const Vector x = load(at.x + n) - x0[0], y = load(at.y + n) - x0[1], z = load(at.z + n) - x0[2];
    const Vector inverse = inverse_root(x * x + y * y + z * z), inverse2 = inverse * inverse;
    const Vector through = (x * load(area.x + n) + y * load(area.y + n) + z * load(area.z + n)) *
                           (inverse2 * inverse2 * inverse);
    const Vector along =
        (x * (load(u.x + n) - u0[0]) + y * (load(u.y + n) - u0[1]) + z * (load(u.z + n) - u0[2])) * through;
    ux += along * x;
    uy += along * y;
    uz += along * z;
  }
  sum[0] = -6 * sum_of_lanes(ux), sum[1] = -6 * sum_of_lanes(uy), sum[2] = -6 * sum_of_lanes(uz);
}

int mark_within_reach(int count, Components at, const float* reach_squared, const float* x0,
                      unsigned char* marks) {
  int hits = 0;
  for (int n = 0; n < count; ++n) {
    const float x = at.x[n] - x0[0], y = at.y[n] - x0[1], z = at.z[n] - x0[2];
    marks[n] = x * x + y * y + z * z < reach_squared[n];
    hits += marks[n];
  }
  return hits;
}

}  // namespace

#define CAPSTAN_JOINED(a, b) a##b
#define CAPSTAN_LOOPS(unit) CAPSTAN_JOINED(kLoops_, unit)
#define CAPSTAN_TEXT(unit) #unit
#define CAPSTAN_NAME(unit) CAPSTAN_TEXT(unit)
const PointLoops CAPSTAN_LOOPS(CAPSTAN_UNIT) = {CAPSTAN_NAME(CAPSTAN_UNIT), stokeslets, stresslets,
                                                mark_within_reach};

}  // namespace capstan
