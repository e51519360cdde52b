#include "solver/fluid/composite/convection.hpp"

#include "solver/fluid/composite/for_each_row.hpp"
#include "solver/fluid/composite/sweep.hpp"

namespace capstan {
namespace {

template <class T>
struct Row {
  const T* g;  ///< of one component, at the row's first cell
  std::ptrdiff_t y, z;
};

/// (u . grad) of one component in one cell, times 2.
template <class T>
[[gnu::always_inline]] inline T carried(const Row<T>& row, int i, T ux, T uy, T uz) {
  return ux * (row.g[i + 1] - row.g[i - 1]) + uy * (row.g[i + row.y] - row.g[i - row.y]) +
         uz * (row.g[i + row.z] - row.g[i - row.z]);
}

}  // namespace

template <class T>
void add_convection(const RowField<T>& moments, double dx, double inertia, RowField<T>& defect) {
  const IndexBox& box = moments.box();
  const std::ptrdiff_t y_stride = moments.y_stride(), z_stride = moments.z_stride();
  const T half = T(inertia / 2), shear_step = T(2 * dx);
  for_each_row(box, [&](int y, int z) {
    const Row<T> gx{moments.row(kGx, y, z), y_stride, z_stride},
        gy{moments.row(kGy, y, z), y_stride, z_stride}, gz{moments.row(kGz, y, z), y_stride, z_stride};
    T *dgx = defect.row(kGx, y, z), *dgy = defect.row(kGy, y, z), *dgz = defect.row(kGz, y, z);
    const T shear = T((y + 0.5) * dx);
    for (int i = 0; i < box.size(0); ++i) {
      const T ux = shear + gx.g[i], uy = gy.g[i], uz = gz.g[i];
      dgx[i] -= half * (carried(gx, i, ux, uy, uz) + uy * shear_step);
      dgy[i] -= half * carried(gy, i, ux, uy, uz);
      dgz[i] -= half * carried(gz, i, ux, uy, uz);
    }
  });
}

template void add_convection(const RowField<float>&, double, double, RowField<float>&);
template void add_convection(const RowField<double>&, double, double, RowField<double>&);

}  // namespace capstan
