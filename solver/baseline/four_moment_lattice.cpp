#include "solver/baseline/four_moment_lattice.hpp"

#include <algorithm>

#include "solver/fluid/lbm/d3q19.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {

using d3q19::e;
using d3q19::kQ;
using d3q19::opposite;

namespace {

/// rho in a row of cells and in the eight rows around it. The components of g of a cell follow its rho at
/// distances of `stride`, 2 `stride` and 3 `stride` numbers.
template <class Real>
struct Neighbours {
  const Real* row[3][3];  ///< [1 + dy][1 + dz]
  std::ptrdiff_t stride;
};

/// phi_q of the direction e_q = (ex, ey, ez) at the cell i.
template <int ex, int ey, int ez, class Real>
[[gnu::always_inline]] inline Real phi(const Real* m, std::ptrdiff_t stride, std::ptrdiff_t i) {
  Real value = m[i];
  if constexpr (ex != 0) value += Real(3 * ex) * m[stride + i];
  if constexpr (ey != 0) value += Real(3 * ey) * m[2 * stride + i];
  if constexpr (ez != 0) value += Real(3 * ez) * m[3 * stride + i];
  return value;
}

/// phi of the two populations that stream into a cell in the directions e and -e.
template <class Real>
struct Pair {
  Real sum, difference;
};
template <int ex, int ey, int ez, class Real>
[[gnu::always_inline]] inline Pair<Real> arriving(const Neighbours<Real>& near, std::ptrdiff_t i) {
  const Real along = phi<ex, ey, ez>(near.row[1 - ey][1 - ez], near.stride, i - ex);
  const Real against = phi<-ex, -ey, -ez>(near.row[1 + ey][1 + ez], near.stride, i + ex);
  return {along + against, along - against};
}

template <class Real>
[[gnu::always_inline]] inline void stream_cell(const Neighbours<Real>& near, Real* to, std::ptrdiff_t i) {
  constexpr Real kRest = Real(1.0 / 3), kAxis = Real(1.0 / 18), kDiagonal = Real(1.0 / 36);
  const auto x = arriving<1, 0, 0>(near, i), y = arriving<0, 1, 0>(near, i), z = arriving<0, 0, 1>(near, i);
  const auto xy = arriving<1, 1, 0>(near, i), xny = arriving<1, -1, 0>(near, i);
  const auto xz = arriving<1, 0, 1>(near, i), xnz = arriving<1, 0, -1>(near, i);
  const auto yz = arriving<0, 1, 1>(near, i), ynz = arriving<0, 1, -1>(near, i);
  to[i] = kRest * near.row[1][1][i] + kAxis * (x.sum + y.sum + z.sum) +
          kDiagonal * (xy.sum + xny.sum + xz.sum + xnz.sum + yz.sum + ynz.sum);
  to[near.stride + i] =
      kAxis * x.difference + kDiagonal * (xy.difference + xny.difference + xz.difference + xnz.difference);
  to[2 * near.stride + i] =
      kAxis * y.difference + kDiagonal * (xy.difference - xny.difference + yz.difference + ynz.difference);
  to[3 * near.stride + i] =
      kAxis * z.difference + kDiagonal * (xz.difference - xnz.difference + yz.difference - ynz.difference);
}

// Prefetches the next row at y + 1, z + 1 (of the nine rows that are read, only this one was not read before)
// and the row that is written next.
template <class Real>
CAPSTAN_VECTOR_UNITS void stream(const Neighbours<Real>& neighbours, Real* to, int count) {
  constexpr std::ptrdiff_t kLine = kNumbersPerLine<Real>;
  const Neighbours<Real> near = neighbours;
  std::ptrdiff_t first = 0;
  for (; first + kLine <= count; first += kLine) {
    for (int moment = 4; moment < 8; ++moment) {
      __builtin_prefetch(near.row[2][2] + moment * near.stride + first);
      __builtin_prefetch(to + moment * near.stride + first, 1);
    }
#pragma GCC ivdep
    for (std::ptrdiff_t i = first; i < first + kLine; ++i) stream_cell(near, to, i);
  }
#pragma GCC ivdep
  for (std::ptrdiff_t i = first; i < count; ++i) stream_cell(near, to, i);
}

}  // namespace

template <class Real>
MomentField<Real>::MomentField(const IndexBox& box) : nx_(box.size(0)), ny_(box.size(1)) {
  constexpr int kLine = kNumbersPerLine<Real>;
  stride_ = whole_lines<Real>(nx_) + kLine;
  numbers_.resize(kLine + std::size_t(ny_) * box.size(2) * 4 * stride_);
}

template <class Real>
void MomentField<Real>::close_row(int y, int z) {
  for (int moment = 0; moment < 4; ++moment) {
    Real* cells = row(moment, y, z);
    cells[-1] = cells[nx_ - 1];
    cells[nx_] = cells[0];
  }
}

template <class Real>
void FourMomentLattice<Real>::step() {
  const int ny = box_.size(1), rows = ny * box_.size(2);
#pragma omp parallel for schedule(static)
  for (int row = 0; row < rows; ++row) {
    const int y = row % ny, z = row / ny;
    if (y == 0 || y == ny - 1)
      step_row_at_wall(y, z);
    else
      step_inner_row(y, z);
    next_.close_row(y, z);
  }
  std::swap(now_, next_);
}

template <class Real>
void FourMomentLattice<Real>::step_inner_row(int y, int z) {
  Neighbours<Real> near{.row = {}, .stride = now_.stride()};
  for (int dy : {-1, 0, 1})
    for (int dz : {-1, 0, 1}) near.row[1 + dy][1 + dz] = now_.row(0, y + dy, periodic(z + dz, box_.size(2)));
  stream(near, next_.row(0, y, z), box_.size(0));
}

/// Half-way bounce-back: a population that left the cell towards the wall returns to it in the opposite
/// direction, with the momentum of the wall added.
template <class Real>
void FourMomentLattice<Real>::step_row_at_wall(int y, int z) {
  for (int moment = 0; moment < 4; ++moment) std::fill_n(next_.row(moment, y, z), box_.size(0), Real(0));
  for (int q = 0; q < kQ; ++q) {
    const int from_y = y - e[q].y, from_z = periodic(z - e[q].z, box_.size(2));
    if (from_y < 0)
      add_arriving(q, opposite[q], now_.row(0, y, z), Real(-6 * e[q].x) * wall_speed_, y, z);
    else if (from_y >= box_.size(1))
      add_arriving(q, opposite[q], now_.row(0, y, z), Real(6 * e[q].x) * wall_speed_, y, z);
    else
      add_arriving(q, q, now_.row(0, from_y, from_z) - e[q].x, Real(0), y, z);
  }
}

/// Adds w_q [1, e_q] (phi_p + more) to the moments of a row.
/// \param m  row of the moments of which phi_p is computed
template <class Real>
void FourMomentLattice<Real>::add_arriving(int q, int p, const Real* m, Real more, int y, int z) {
  const std::ptrdiff_t stride = now_.stride();
  const Real weight = Real(d3q19::weight(q)), px = Real(3 * e[p].x), py = Real(3 * e[p].y),
             pz = Real(3 * e[p].z);
  const Real to_x = Real(e[q].x), to_y = Real(e[q].y), to_z = Real(e[q].z);
  const int nx = box_.size(0);
  Real* to = next_.row(0, y, z);
#pragma GCC ivdep
  for (int x = 0; x < nx; ++x) {
    const Real value =
        weight * (m[x] + more + px * m[stride + x] + py * m[2 * stride + x] + pz * m[3 * stride + x]);
    to[x] += value;
    to[stride + x] += to_x * value;
    to[2 * stride + x] += to_y * value;
    to[3 * stride + x] += to_z * value;
  }
}

template class MomentField<float>;
template class MomentField<double>;
template class FourMomentLattice<float>;
template class FourMomentLattice<double>;

}  // namespace capstan
