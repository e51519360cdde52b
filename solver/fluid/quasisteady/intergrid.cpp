#include "solver/fluid/quasisteady/intergrid.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "solver/grid/for_each_row.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

constexpr int kBlock = 128;     // coarse numbers of a row at a time
constexpr int kComponents = 5;  // at most

// Loops over whole registers read a little beyond a row, into what follows it in memory (RowField).

/// A child's centre stands a quarter of a coarse cell from its parent's: at -1/4 for even indices, +1/4 for
/// odd ones.
constexpr double side_of(int child) { return (child & 1) ? 0.25 : -0.25; }

/// Weights of the parent's neighbour before it, itself, and the one behind: the parabola through the three.
template <class T>
struct Parabola {
  T before, at, behind;
};
template <class T>
constexpr Parabola<T> parabola(int child) {
  const double t = side_of(child);
  return {T(t * (t - 1) / 2), T(1 - t * t), T(t * (t + 1) / 2)};
}

/// Rows of one grid and the row of the other that is made of them, from their first components on.
template <class T>
struct FourRows {
  std::array<const T*, 4> from;
  T* to;
  std::ptrdiff_t from_component, to_component;  ///< distances to the next component
  int coarse_count;                             ///< cells, of whichever is coarser
};

/// From the rows of the children of a row of coarse cells. Components in turn, step by step: what is read was
/// written a while ago.
template <class T>
CAPSTAN_VECTOR_UNITS void average_rows(const FourRows<T>& rows, std::span<const double> factors) {
  alignas(64) T sums[kComponents][2 * kBlock];
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

/// From the coarse rows around a fine one, the nearest first.
template <class T>
CAPSTAN_VECTOR_UNITS void add_linear_rows(const FourRows<T>& rows, std::span<const double> factors) {
  alignas(64) T along[kComponents][kBlock + 2 * kLanes], change[kComponents][2 * kBlock + 2 * kLanes];
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

/// Rows of numbers over two axes; the rows of the inner one stand behind each other.
template <class R>
struct RowGrid {
  R* first;
  std::ptrdiff_t inner_stride, outer_stride;
  int inner, outer;

  R* row(int i, int j) const { return first + i * inner_stride + j * outer_stride; }
};

/// In x: all children of `parents` cells of each row.
template <class T>
CAPSTAN_VECTOR_UNITS void interpolate_in_x(const RowGrid<const T>& coarse, std::ptrdiff_t component,
                                           int parents, std::span<const double> factors,
                                           const RowGrid<T>& out) {
  constexpr Parabola<T> even = parabola<T>(0), odd = parabola<T>(1);
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

/// In the inner axis: the rows of the children `first` ... of parents whose rows, with a neighbour on each
/// side, are given.
template <class T>
CAPSTAN_VECTOR_UNITS void interpolate_between_rows(const RowGrid<const T>& parents, int first, int count,
                                                   const RowGrid<T>& out) {
  for (int j = 0; j < out.outer; ++j)
    for (int i = 0; i < out.inner; ++i) {
      const Parabola<T> weights = parabola<T>(first + i);
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
  const int fine_x = 2 * region.lo[0] - fine.box().lo[0], coarse_x = region.lo[0] - coarse.box().lo[0];
  for_each_row(region, [&](int y, int z) {
    const auto child = [&](int dy, int dz) { return fine.row(0, 2 * y + dy, 2 * z + dz) + fine_x; };
    average_rows(FourRows<T>{{child(0, 0), child(1, 0), child(0, 1), child(1, 1)},
                             coarse.row(0, y, z) + coarse_x,
                             fine.component_stride(),
                             coarse.component_stride(),
                             region.size(0)},
                 factors);
  });
}

template <class T>
void add_linear(const RowField<T>& coarse, RowField<T>& fine, const IndexBox& region,
                std::span<const double> factors) {
  const int coarse_x = parent(region.lo[0]) - coarse.box().lo[0], fine_x = region.lo[0] - fine.box().lo[0];
  for_each_row(region, [&](int y, int z) {
    const int Y = parent(y), Z = parent(z), near_Y = (y & 1) ? Y + 1 : Y - 1,
              near_Z = (z & 1) ? Z + 1 : Z - 1;
    const auto row = [&](int at_y, int at_z) { return coarse.row(0, at_y, at_z) + coarse_x; };
    add_linear_rows(FourRows<T>{{row(Y, Z), row(near_Y, Z), row(Y, near_Z), row(near_Y, near_Z)},
                                fine.row(0, y, z) + fine_x,
                                coarse.component_stride(),
                                fine.component_stride(),
                                region.size(0) / 2},
                    factors);
  });
}

// Direction by direction: x in the coarse rows that are needed, then y, then z. Of every parent in x all
// children are made, and those of the region taken in the end.
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
  interpolate_in_x(RowGrid<const T>{first_row, coarse.y_stride(), coarse.z_stride(), NY, NZ},
                   coarse.component_stride(), parents.size(0), factors,
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
        row[0] = child[0];  // all there is of a ghost layer of x
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
