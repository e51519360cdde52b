#include "solver/grid/transfers.hpp"

#include <algorithm>
#include <vector>

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

constexpr int kBlock = 128;  // coarse cells of a row that are processed at a time
constexpr int kMaxComponents = 5;

// Loops over whole registers read a little beyond a row, into the memory that follows it (see RowField).

/// Distance from a parent's centre to that of its child, in coarse cells: the child has an even or an odd
/// index.
constexpr double offset_of(int child) { return (child & 1) ? 0.25 : -0.25; }

/// Weights of the values at -1, 0 and 1 for the value of their parabola at a child of the cell 0.
template <class T>
struct ParabolaWeights {
  T before, at, behind;
};
template <class T>
constexpr ParabolaWeights<T> parabola_weights(int child) {
  const double t = offset_of(child);
  return {T(t * (t - 1) / 2), T(1 - t * t), T(t * (t + 1) / 2)};
}

/// Four rows of one grid, the row of the other grid that is computed from them, and for both the distance in
/// memory from one component to the next.
template <class T>
struct RowTransfer {
  FourRows<T> from;
  T* to;
  std::ptrdiff_t from_component, to_component;
  int coarse_count;  ///< cells of the row that is on the coarser grid
};

/// A coarse row from the four rows of its children. Each step is done for all components before the next step
/// starts. So the numbers that a step reads were not written immediately before, and loads do not wait for
/// stores.
template <class T>
CAPSTAN_VECTOR_UNITS void average_rows(const RowTransfer<T>& rows, std::span<const double> factors) {
  alignas(64) T sums[kMaxComponents][2 * kBlock];
  const int K = int(factors.size());
  for (int first = 0; first < rows.coarse_count; first += kBlock) {
    const int count = std::min(kBlock, rows.coarse_count - first);
    for (int k = 0; k < K; ++k) {
      const std::ptrdiff_t at = k * rows.from_component + 2 * first;
      const T *a = rows.from[0] + at, *b = rows.from[1] + at, *c = rows.from[2] + at, *d = rows.from[3] + at;
      for (int i = 0; i < whole_lanes(2 * count); ++i) sums[k][i] = (a[i] + b[i]) + (c[i] + d[i]);
    }
    for (int k = 0; k < K; ++k) {
      T* __restrict parents = rows.to + k * rows.to_component + first;
      const T factor = T(factors[k] / 8);
      for (int i = 0; i < count; ++i) parents[i] = factor * (sums[k][2 * i] + sums[k][2 * i + 1]);
    }
  }
}

/// A fine row from the four coarse rows around it: first in y and z, with the common factor 1/64 of all
/// weights, then in x.
template <class T>
CAPSTAN_VECTOR_UNITS void add_linear_rows(const RowTransfer<T>& rows, std::span<const double> factors) {
  alignas(64) T along[kMaxComponents][kBlock + 2 * kLanes], change[kMaxComponents][2 * kBlock + 2 * kLanes];
  const int K = int(factors.size());
  for (int first = 0; first < rows.coarse_count; first += kBlock) {
    const int count = std::min(kBlock, rows.coarse_count - first);
    for (int k = 0; k < K; ++k) {
      const std::ptrdiff_t at = k * rows.from_component + first - 1;
      const T *a = rows.from[0] + at, *b = rows.from[1] + at, *c = rows.from[2] + at, *d = rows.from[3] + at;
      const T factor = T(factors[k] / 64);
      for (int i = 0; i < whole_lanes(count + 2); ++i)
        along[k][i] = factor * (9 * a[i] + 3 * (b[i] + c[i]) + d[i]);
    }
    for (int k = 0; k < K; ++k)
      for (int i = 0; i < count; ++i) {
        change[k][2 * i] = 3 * along[k][i + 1] + along[k][i];
        change[k][2 * i + 1] = 3 * along[k][i + 1] + along[k][i + 2];
      }
    for (int k = 0; k < K; ++k) {
      T* __restrict fine = rows.to + k * rows.to_component + 2 * first;
      for (int i = 0; i < 2 * count; ++i) fine[i] += change[k][i];
    }
  }
}

/// A two-dimensional array of rows of numbers.
template <class R>
struct RowGrid {
  R* first;
  std::ptrdiff_t inner_stride, outer_stride;
  int inner, outer;

  R* row(int i, int j) const { return first + i * inner_stride + j * outer_stride; }
};

/// Interpolation in x: computes both children of each of the `parents` coarse cells of each row.
template <class T>
CAPSTAN_VECTOR_UNITS void interpolate_in_x(const RowGrid<const T>& coarse, std::ptrdiff_t component,
                                           int parents, std::span<const double> factors,
                                           const RowGrid<T>& out) {
  constexpr ParabolaWeights<T> even = parabola_weights<T>(0), odd = parabola_weights<T>(1);
  for (int j = 0; j < coarse.outer; ++j)
    for (int i = 0; i < coarse.inner; ++i)
      for (std::size_t k = 0; k < factors.size(); ++k) {
        const T* __restrict row = coarse.row(i, j) + std::ptrdiff_t(k) * component;
        T* __restrict children = out.row(i, j) + 2 * std::ptrdiff_t(k) * parents;
        const T factor = T(factors[k]);
        for (int x = 0; x < parents; ++x) {
          children[2 * x] = factor * (even.before * row[x - 1] + even.at * row[x] + even.behind * row[x + 1]);
          children[2 * x + 1] =
              factor * (odd.before * row[x - 1] + odd.at * row[x] + odd.behind * row[x + 1]);
        }
      }
}

/// Interpolation along the inner axis: computes the rows of the children `first`, `first` + 1, ... from the
/// rows of their parents. `parents` has one further row on each side.
template <class T>
CAPSTAN_VECTOR_UNITS void interpolate_between_rows(const RowGrid<const T>& parents, int first, int count,
                                                   const RowGrid<T>& out) {
  for (int j = 0; j < out.outer; ++j)
    for (int i = 0; i < out.inner; ++i) {
      const ParabolaWeights<T> weights = parabola_weights<T>(first + i);
      const int at = 1 + parent(first + i) - parent(first);
      const T *before = parents.row(at - 1, j), *middle = parents.row(at, j),
              *behind = parents.row(at + 1, j);
      T* __restrict row = out.row(i, j);
      for (int x = 0; x < count; ++x)
        row[x] = weights.before * before[x] + weights.at * middle[x] + weights.behind * behind[x];
    }
}

}  // namespace

template <class T>
void average_children(const RowField<T>& fine, RowField<T>& coarse, const IndexBox& region,
                      std::span<const double> factors) {
  const int coarse_x = region.lo[0] - coarse.box().lo[0];
  for_each_row(region, [&](int y, int z) {
    average_rows(RowTransfer<T>{.from = rows_of_children(fine, region.lo[0], y, z),
                                .to = coarse.row(0, y, z) + coarse_x,
                                .from_component = fine.strides().component,
                                .to_component = coarse.strides().component,
                                .coarse_count = region.size(0)},
                 factors);
  });
}

template <class T>
void add_linear(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                std::span<const double> factors) {
  const int fine_x = region.lo[0] - fine.box().lo[0];
  for_each_row(region, [&](int y, int z) {
    add_linear_rows(RowTransfer<T>{.from = rows_around(coarse, parent(region.lo[0]), y, z),
                                   .to = fine.row(0, y, z) + fine_x,
                                   .from_component = coarse.strides().component,
                                   .to_component = fine.strides().component,
                                   .coarse_count = region.size(0) / 2},
                    factors);
  });
}

// The axes are interpolated one after the other: x in all coarse rows of the stencil, then y, then z. In x
// both children of every parent are computed; the last step copies only the cells of the region.
template <class T>
void interpolate(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                 std::span<const double> factors) {
  const IndexBox parents = coarsened(region), needed = grown(parents, 1);
  const int K = fine.components(), nx = 2 * parents.size(0), ny = region.size(1), nz = region.size(2);
  const int NY = needed.size(1), NZ = needed.size(2);
  const std::ptrdiff_t numbers = std::ptrdiff_t(K) * nx;
  thread_local std::vector<T> along_x, along_y, children;
  along_x.resize(numbers * NY * NZ), along_y.resize(numbers * ny * NZ), children.resize(numbers * ny * nz);

  const T* first_row = coarse.row(0, needed.lo[1], needed.lo[2]) + (parents.lo[0] - coarse.box().lo[0]);
  interpolate_in_x(RowGrid<const T>{first_row, coarse.strides().y, coarse.strides().z, NY, NZ},
                   coarse.strides().component, parents.size(0), factors,
                   RowGrid<T>{along_x.data(), numbers, numbers * NY, NY, NZ});
  interpolate_between_rows(RowGrid<const T>{along_x.data(), numbers, numbers * NY, NY, NZ}, region.lo[1],
                           int(numbers), RowGrid<T>{along_y.data(), numbers, numbers * ny, ny, NZ});
  interpolate_between_rows(RowGrid<const T>{along_y.data(), numbers * ny, numbers, NZ, ny}, region.lo[2],
                           int(numbers), RowGrid<T>{children.data(), numbers * ny, numbers, nz, ny});
  const T* child = children.data() + (region.lo[0] - 2 * parents.lo[0]);
  for (int z = region.lo[2]; z < region.hi[2]; ++z)
    for (int y = region.lo[1]; y < region.hi[1]; ++y)
      for (int k = 0; k < K; ++k, child += nx) {
        T* row = fine.row(k, y, z) + (region.lo[0] - fine.box().lo[0]);
        row[0] = child[0];  // a ghost layer of x has this cell only
        if (region.size(0) > 1) std::copy_n(child + 1, region.size(0) - 1, row + 1);
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
