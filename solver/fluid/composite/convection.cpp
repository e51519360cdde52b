#include "solver/fluid/composite/convection.hpp"

#include "solver/coupling/vector_units.hpp"
#include "solver/fluid/composite/for_each_row.hpp"
#include "solver/fluid/composite/sweep.hpp"

namespace capstan {
namespace {

template <class T>
struct Row {
  const T* moments;  ///< at the row's first cell, as the next two
  const T* defect;
  T* out;
  Strides strides;
  int count;
  T half_inertia, shear, shear_step;  ///< shear: of the undisturbed flow in this row
};

/// (u . grad) of one component in one cell, times 2.
template <class T>
[[gnu::always_inline]] inline T carried(const T* g, const Strides& s, int i, T ux, T uy, T uz) {
  return ux * (g[i + 1] - g[i - 1]) + uy * (g[i + s.y] - g[i - s.y]) + uz * (g[i + s.z] - g[i - s.z]);
}

template <class T>
CAPSTAN_VECTOR_UNITS void subtract(const Row<T>& row) {
  const Strides& s = row.strides;
  const T *gx = row.moments + kGx * s.component, *gy = row.moments + kGy * s.component,
          *gz = row.moments + kGz * s.component;
#pragma GCC ivdep
  for (int i = 0; i < row.count; ++i) {
    const T ux = row.shear + gx[i], uy = gy[i], uz = gz[i];
    const auto put = [&](int k, T twice) {
      const std::ptrdiff_t at = i + k * s.component;
      row.out[at] = row.defect[at] - row.half_inertia * twice;
    };
    row.out[i] = row.defect[i];
    put(kGx, carried(gx, s, i, ux, uy, uz) + uy * row.shear_step);
    put(kGy, carried(gy, s, i, ux, uy, uz));
    put(kGz, carried(gz, s, i, ux, uy, uz));
  }
}

}  // namespace

template <class T>
void subtract_convection(const RowField<T>& moments, double dx, double inertia, const RowField<T>& defect,
                         RowField<T>& out) {
  const IndexBox& box = moments.box();
  const Strides strides{moments.component_stride(), moments.y_stride(), moments.z_stride()};
  for_each_row(box, [&](int y, int z) {
    subtract(Row<T>{moments.row(kRho, y, z), defect.row(kRho, y, z), out.row(kRho, y, z), strides,
                    box.size(0), T(inertia / 2), T((y + 0.5) * dx), T(2 * dx)});
  });
}

template void subtract_convection(const RowField<float>&, double, double, const RowField<float>&,
                                  RowField<float>&);
template void subtract_convection(const RowField<double>&, double, double, const RowField<double>&,
                                  RowField<double>&);

}  // namespace capstan
