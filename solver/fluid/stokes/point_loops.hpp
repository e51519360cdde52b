#pragma once
// The loops of point_sums.hpp over plain arrays, compiled once for each instruction set.
#include <vector>

namespace capstan {

/// The x, y and z components of an array of points; the number of points is a multiple of 16.
struct Components {
  const float *x, *y, *z;
};

/// The loops for one instruction set; see point_sums.hpp. `count` is a multiple of 16, x0, u0 and sum are 3
/// numbers.
struct PointLoops {
  const char* unit;  ///< the instruction set, e.g. "x86_64_v4"
  void (*stokeslets)(int count, Components at, Components force, const float* x0, float* sum);
  void (*stresslets)(int count, Components at, Components area, Components u, const float* x0,
                     const float* u0, float* sum);
  int (*mark_within_reach)(int count, Components at, const float* reach_squared, const float* x0,
                           unsigned char* marks);
};

extern const PointLoops kLoops_x86_64;     ///< SSE2: any x86-64 processor
extern const PointLoops kLoops_x86_64_v3;  ///< AVX2
extern const PointLoops kLoops_x86_64_v4;  ///< AVX-512

/// The loops that this processor can run, the widest last.
std::vector<const PointLoops*> supported_point_loops();

}  // namespace capstan
