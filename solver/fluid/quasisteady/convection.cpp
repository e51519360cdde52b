#include "solver/fluid/quasisteady/convection.hpp"

#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

/// subtract_convection() for one row of cells. The pointers are to its first cell.
template <class T>
CAPSTAN_VECTOR_UNITS void subtract(const T* moments, const Strides& s, int count, T half_inertia,
                                   T* __restrict defect) {
  const T *gx = moments + kGx * s.component, *gy = moments + kGy * s.component,
          *gz = moments + kGz * s.component;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const T ux = half_inertia * gx[i], uy = half_inertia * gy[i], uz = half_inertia * gz[i];
    const auto subtract_one = [&](const T* g, int k) {
      defect[i + k * s.component] -=
          ux * (g[i + 1] - g[i - 1]) + uy * (g[i + s.y] - g[i - s.y]) + uz * (g[i + s.z] - g[i - s.z]);
    };
    subtract_one(gx, kGx), subtract_one(gy, kGy), subtract_one(gz, kGz);
  }
}

}  // namespace

template <class T>
void subtract_convection(const RowField<T>& moments, double inertia, RowField<T>& defect) {
  for_each_row(moments.box(), [&](int y, int z) {
    subtract(moments.row(0, y, z), moments.strides(), moments.box().size(0), T(inertia / 2),
             defect.row(0, y, z));
  });
}

template void subtract_convection(const RowField<float>&, double, RowField<float>&);
template void subtract_convection(const RowField<double>&, double, RowField<double>&);

}  // namespace capstan
