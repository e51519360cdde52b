#pragma once
// The loops of point_sums.hpp over plain arrays, compiled once for each kind of vector unit.
#include <vector>

namespace capstan {

/// Three numbers a point, as many points as fill whole vectors of 16 lanes.
struct Components {
  const float *x, *y, *z;
};

struct PointLoops {
  const char* unit;  ///< as compilers name it, e.g. "x86-64-v4"
  void (*stokeslets)(int count, Components at, Components force, const float* x0, float* sum);
  void (*stresslets)(int count, Components at, Components area, Components u, const float* x0,
                     const float* u0, float* sum);
  int (*mark_within_reach)(int count, Components at, const float* reach_squared, const float* x0,
                           unsigned char* marks);
};

extern const PointLoops kLoops_x86_64;     ///< SSE2: every 64-bit processor of the kind
extern const PointLoops kLoops_x86_64_v3;  ///< AVX2
extern const PointLoops kLoops_x86_64_v4;  ///< AVX-512

/// Those that this processor can run, the widest last.
std::vector<const PointLoops*> supported_point_loops();

}  // namespace capstan
