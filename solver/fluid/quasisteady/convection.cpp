#include "solver/fluid/quasisteady/convection.hpp"

#include "solver/fluid/quasisteady/sweep.hpp"
#include "solver/grid/for_each_row.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

/// A row of cells; pointers at its first one.
template <class T>
CAPSTAN_VECTOR_UNITS void subtract(const T* moments, const Strides& s, int count, T half_inertia,
                                   T* __restrict defect) {
  const T *gx = moments + kGx * s.component, *gy = moments + kGy * s.component,
          *gz = moments + kGz * s.component;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const T ux = half_inertia * gx[i], uy = half_inertia * gy[i], uz = half_inertia * gz[i];
    const auto subtract_carried = [&](const T* g, int k) {
      defect[i + k * s.component] -=
          ux * (g[i + 1] - g[i - 1]) + uy * (g[i + s.y] - g[i - s.y]) + uz * (g[i + s.z] - g[i - s.z]);
    };
    subtract_carried(gx, kGx), subtract_carried(gy, kGy), subtract_carried(gz, kGz);
  }
}

}  // namespace

template <class T>
void subtract_convection(const RowField<T>& moments, double inertia, RowField<T>& defect) {
  const Strides strides{moments.component_stride(), moments.y_stride(), moments.z_stride()};
  for_each_row(moments.box(), [&](int y, int z) {
    subtract(moments.row(0, y, z), strides, moments.box().size(0), T(inertia / 2), defect.row(0, y, z));
  });
}

template void subtract_convection(const RowField<float>&, double, RowField<float>&);
template void subtract_convection(const RowField<double>&, double, RowField<double>&);

}  // namespace capstan
