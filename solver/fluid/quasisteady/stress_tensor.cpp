#include "solver/fluid/quasisteady/stress_tensor.hpp"

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

/// q = c P
template <class T>
[[gnu::always_inline]] inline void put_isotropic(const TensorRow<T>& row) {
  const T* __restrict p = row.p;
  const T* __restrict c = row.interface;
  T* __restrict q = row.q;
  for (int k = 0; k < kStresses; ++k) {
    const std::ptrdiff_t at = k * row.stress_stride;
    const T added = k == kXY ? row.undisturbed : 0;
#pragma GCC ivdep
    for (int i = 0; i < row.count; ++i) q[at + i] = c[i] * (p[at + i] + added);
  }
}

/// q += weight (n t + t n)
template <class T>
[[gnu::always_inline]] inline void add_shear(const TensorRow<T>& row, const T* __restrict weight, T sign) {
  const std::ptrdiff_t s = row.stress_stride, f = row.interface_stride;
  const T* __restrict p = row.p;
  const T* __restrict normal = row.interface + kNormalX * f;
  T* __restrict q = row.q;
#pragma GCC ivdep
  for (int i = 0; i < row.count; ++i) {
    const T nx = normal[i], ny = normal[i + f], nz = normal[i + 2 * f];
    const T xx = p[i], yy = p[i + s], xy = p[i + 2 * s] + row.undisturbed, xz = p[i + 3 * s],
            yz = p[i + 4 * s];
    const T px = xx * nx + xy * ny + xz * nz, py = xy * nx + yy * ny + yz * nz,
            pz = xz * nx + yz * ny - (xx + yy) * nz;
    const T along = px * nx + py * ny + pz * nz, w = sign * weight[i];
    const T tx = w * (px - along * nx), ty = w * (py - along * ny), tz = w * (pz - along * nz);
    q[i] += 2 * nx * tx;
    q[i + s] += 2 * ny * ty;
    q[i + 2 * s] += nx * ty + ny * tx;
    q[i + 3 * s] += nx * tz + nz * tx;
    q[i + 4 * s] += ny * tz + nz * ty;
  }
}

template <class T>
[[gnu::always_inline]] inline void put_passed(const TensorRow<T>& row, bool is_near_membrane) {
  put_isotropic(row);
  if (is_near_membrane) add_shear(row, row.interface + kHarmonic * row.interface_stride, T(1));
}

template <class T>
[[gnu::always_inline]] inline void put_without_shear(const TensorRow<T>& row, bool is_near_membrane) {
  put_isotropic(row);
  if (is_near_membrane) add_shear(row, row.interface + kArithmetic * row.interface_stride, T(-1));
}

}  // namespace

CAPSTAN_VECTOR_UNITS void put_passed_stress(const TensorRow<float>& row, bool is_near_membrane) {
  put_passed(row, is_near_membrane);
}
CAPSTAN_VECTOR_UNITS void put_passed_stress(const TensorRow<double>& row, bool is_near_membrane) {
  put_passed(row, is_near_membrane);
}
CAPSTAN_VECTOR_UNITS void put_stress_without_shear(const TensorRow<float>& row, bool is_near_membrane) {
  put_without_shear(row, is_near_membrane);
}
CAPSTAN_VECTOR_UNITS void put_stress_without_shear(const TensorRow<double>& row, bool is_near_membrane) {
  put_without_shear(row, is_near_membrane);
}

}  // namespace capstan
