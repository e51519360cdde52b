#include "solver/fluid/composite/intergrid.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "solver/fluid/composite/for_each_row.hpp"
#include "solver/coupling/vector_units.hpp"

namespace capstan {
namespace {

/// A child's centre stands a quarter of a coarse cell from its parent's: at -1/4 for even indices, +1/4 for
/// odd ones.
constexpr double side_of(int child) { return (child & 1) ? 0.25 : -0.25; }

/// Weights of the parent's neighbour before it, itself, and the one behind: the parabola through the three.
constexpr std::array<double, 3> parabola(int child) {
  const double t = side_of(child);
  return {t * (t - 1) / 2, 1 - t * t, t * (t + 1) / 2};
}

template <class T>
CAPSTAN_VECTOR_UNITS void average_row(const std::array<const T*, 4>& rows, T* __restrict out,
                                               int count, T factor) {
  const T* __restrict a = rows[0], * __restrict b = rows[1], * __restrict c = rows[2], * __restrict d = rows[3];
#pragma GCC ivdep
  for (int i = 0; i < count; ++i)
    out[i] = factor * ((a[2 * i] + a[2 * i + 1]) + (b[2 * i] + b[2 * i + 1]) + (c[2 * i] + c[2 * i + 1]) +
                       (d[2 * i] + d[2 * i + 1]));
}

/// out (children of the cells 0 ... count - 1) += interpolation of the four rows around, the nearest first.
template <class T>
CAPSTAN_VECTOR_UNITS void add_linear_row(const std::array<const T*, 4>& rows, T* __restrict out,
                                                  int count, T factor) {
  constexpr int kBlock = 128;
  T along[kBlock + 2];
  for (int first = 0; first < count; first += kBlock) {
    const int n = std::min(kBlock, count - first);
    const T* __restrict a = rows[0] + first, * __restrict b = rows[1] + first, * __restrict c = rows[2] + first, * __restrict d = rows[3] + first;
#pragma GCC ivdep
    for (int i = -1; i <= n; ++i) along[i + 1] = factor * (T(9) * a[i] + T(3) * (b[i] + c[i]) + d[i]);
    T* __restrict children = out + 2 * first;
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
      children[2 * i] += T(0.75) * along[i + 1] + T(0.25) * along[i];
      children[2 * i + 1] += T(0.75) * along[i + 1] + T(0.25) * along[i + 2];
    }
  }
}

}  // namespace

template <class T>
void average_children(const RowField<T>& fine, RowField<T>& coarse, const IndexBox& region,
                      std::span<const double> factors) {
  const int fine_x = 2 * region.lo[0] - fine.box().lo[0], coarse_x = region.lo[0] - coarse.box().lo[0];
  for_each_row(region, [&](int y, int z) {
    for (int k = 0; k < coarse.components(); ++k)
      average_row<T>({fine.row(k, 2 * y, 2 * z) + fine_x, fine.row(k, 2 * y + 1, 2 * z) + fine_x,
               fine.row(k, 2 * y, 2 * z + 1) + fine_x, fine.row(k, 2 * y + 1, 2 * z + 1) + fine_x},
              coarse.row(k, y, z) + coarse_x, region.size(0), T(factors[k] / 8));
  });
}

template <class T>
void add_linear(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                std::span<const double> factors) {
  const int coarse_x = parent(region.lo[0]) - coarse.box().lo[0], fine_x = region.lo[0] - fine.box().lo[0];
  for_each_row(region, [&](int y, int z) {
    const int Y = parent(y), Z = parent(z), near_Y = (y & 1) ? Y + 1 : Y - 1,
              near_Z = (z & 1) ? Z + 1 : Z - 1;
    for (int k = 0; k < fine.components(); ++k)
      add_linear_row<T>({coarse.row(k, Y, Z) + coarse_x, coarse.row(k, near_Y, Z) + coarse_x,
               coarse.row(k, Y, near_Z) + coarse_x, coarse.row(k, near_Y, near_Z) + coarse_x},
              fine.row(k, y, z) + fine_x, region.size(0) / 2, T(factors[k] / 16));
  });
}

// Direction by direction: x in the coarse rows that are needed, then y, then z.
template <class T>
void interpolate(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                 std::span<const double> factors) {
  const IndexBox needed = grown(coarsened(region), 1);
  const int nx = region.size(0), ny = region.size(1), NY = needed.size(1), NZ = needed.size(2);
  std::vector<T> along_x(std::size_t(nx) * NY * NZ), along_y(std::size_t(nx) * ny * NZ);
  for (int k = 0; k < fine.components(); ++k) {
    for (int Z = 0; Z < NZ; ++Z)
      for (int Y = 0; Y < NY; ++Y) {
        const T* row = coarse.row(k, needed.lo[1] + Y, needed.lo[2] + Z) - coarse.box().lo[0];
        T* out = &along_x[(std::size_t(Z) * NY + Y) * nx];
        for (int i = 0; i < nx; ++i) {
          const int x = region.lo[0] + i, X = parent(x);
          const auto w = parabola(x);
          out[i] = T(factors[k]) * (T(w[0]) * row[X - 1] + T(w[1]) * row[X] + T(w[2]) * row[X + 1]);
        }
      }
    for (int Z = 0; Z < NZ; ++Z)
      for (int j = 0; j < ny; ++j) {
        const int y = region.lo[1] + j, Y = parent(y) - needed.lo[1];
        const auto w = parabola(y);
        const T* rows = &along_x[(std::size_t(Z) * NY + Y) * nx];
        T* out = &along_y[(std::size_t(Z) * ny + j) * nx];
        for (int i = 0; i < nx; ++i)
          out[i] = T(w[0]) * rows[i - nx] + T(w[1]) * rows[i] + T(w[2]) * rows[i + nx];
      }
    const std::ptrdiff_t plane = std::ptrdiff_t(nx) * ny;
    for (int z = region.lo[2]; z < region.hi[2]; ++z)
      for (int j = 0; j < ny; ++j) {
        const int Z = parent(z) - needed.lo[2];
        const auto w = parabola(z);
        const T* rows = &along_y[std::size_t(Z) * plane + std::size_t(j) * nx];
        T* out = fine.row(k, region.lo[1] + j, z) + (region.lo[0] - fine.box().lo[0]);
        for (int i = 0; i < nx; ++i)
          out[i] = T(w[0]) * rows[i - plane] + T(w[1]) * rows[i] + T(w[2]) * rows[i + plane];
      }
  }
}

#define CAPSTAN_INSTANTIATE(T)                                                                          \
  template void average_children(const RowField<T>&, RowField<T>&, const IndexBox&,                     \
                                 std::span<const double>);                                              \
  template void add_linear(const RowField<T>&, RowField<T>&, const IndexBox&, std::span<const double>); \
  template void interpolate(const RowField<T>&, RowField<T>&, const IndexBox&, std::span<const double>);
CAPSTAN_INSTANTIATE(float)
CAPSTAN_INSTANTIATE(double)

}  // namespace capstan
