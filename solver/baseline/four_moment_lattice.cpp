#include "solver/baseline/four_moment_lattice.hpp"

namespace capstan {

using d3q19::e;
using d3q19::kQ;
using d3q19::opposite;

namespace {

/// The moments of a row of cells.
template <class Real>
using Moments = std::array<const Real*, 4>;

/// A row's neighbours, the row itself among them.
template <class Real>
struct Neighbours {
  Moments<Real> row[3][3];  ///< [1 + dy][1 + dz]
};

template <int ex, int ey, int ez, class Real>
[[gnu::always_inline]] inline Real phi(const Moments<Real>& m, std::ptrdiff_t i) {
  Real value = m[0][i];
  if constexpr (ex != 0) value += Real(3 * ex) * m[1][i];
  if constexpr (ey != 0) value += Real(3 * ey) * m[2][i];
  if constexpr (ez != 0) value += Real(3 * ez) * m[3][i];
  return value;
}

/// What arrives along e and against it.
template <class Real>
struct Pair {
  Real sum, difference;
};
template <int ex, int ey, int ez, class Real>
[[gnu::always_inline]] inline Pair<Real> arriving(const Neighbours<Real>& near, std::ptrdiff_t i) {
  const Real along = phi<ex, ey, ez>(near.row[1 - ey][1 - ez], i - ex);
  const Real against = phi<-ex, -ey, -ez>(near.row[1 + ey][1 + ez], i + ex);
  return {along + against, along - against};
}

template <class Real>
[[gnu::always_inline]] inline void stream_row(const Neighbours<Real>& neighbours,
                                              const std::array<Real*, 4>& to, std::ptrdiff_t count) {
  const Neighbours<Real> near = neighbours;
  Real *rho = to[0], *gx = to[1], *gy = to[2], *gz = to[3];
  constexpr Real kRest = Real(1.0 / 3), kAxis = Real(1.0 / 18), kDiagonal = Real(1.0 / 36);
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto x = arriving<1, 0, 0>(near, i), y = arriving<0, 1, 0>(near, i), z = arriving<0, 0, 1>(near, i);
    const auto xy = arriving<1, 1, 0>(near, i), xny = arriving<1, -1, 0>(near, i);
    const auto xz = arriving<1, 0, 1>(near, i), xnz = arriving<1, 0, -1>(near, i);
    const auto yz = arriving<0, 1, 1>(near, i), ynz = arriving<0, 1, -1>(near, i);
    rho[i] = kRest * near.row[1][1][0][i] + kAxis * (x.sum + y.sum + z.sum) +
             kDiagonal * (xy.sum + xny.sum + xz.sum + xnz.sum + yz.sum + ynz.sum);
    gx[i] =
        kAxis * x.difference + kDiagonal * (xy.difference + xny.difference + xz.difference + xnz.difference);
    gy[i] =
        kAxis * y.difference + kDiagonal * (xy.difference - xny.difference + yz.difference + ynz.difference);
    gz[i] =
        kAxis * z.difference + kDiagonal * (xz.difference - xnz.difference + yz.difference - ynz.difference);
  }
}

#define CAPSTAN_VECTOR_UNITS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
CAPSTAN_VECTOR_UNITS void stream(const Neighbours<double>& near, const std::array<double*, 4>& to,
                                 int count) {
  stream_row(near, to, count);
}
CAPSTAN_VECTOR_UNITS void stream(const Neighbours<float>& near, const std::array<float*, 4>& to, int count) {
  stream_row(near, to, count);
}

template <class Real, class Field>
std::array<Real*, 4> rows_of(Field& field, int y, int z) {
  return {field.row(0, y, z), field.row(1, y, z), field.row(2, y, z), field.row(3, y, z)};
}

template <class Real>
Real phi(const Moments<Real>& m, int q, int x) {
  return m[0][x] + 3 * (Real(e[q].x) * m[1][x] + Real(e[q].y) * m[2][x] + Real(e[q].z) * m[3][x]);
}

}  // namespace

template <class Real>
MomentField<Real>::MomentField(Extent extent) : nx_(extent.nx), ny_(extent.ny) {
  constexpr std::size_t kLine = kCacheLine / sizeof(Real);
  stride_ = (nx_ + kLine - 1) / kLine * kLine + kLine;
  for (auto& moment : moments_) moment.resize(kLine + std::size_t(extent.ny) * extent.nz * stride_);
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
  const int rows = extent_.ny * extent_.nz;
#pragma omp parallel for schedule(static)
  for (int row = 0; row < rows; ++row) {
    const int y = row % extent_.ny, z = row / extent_.ny;
    if (y == 0 || y == extent_.ny - 1)
      step_row_at_wall(y, z);
    else
      step_inner_row(y, z);
    next_.close_row(y, z);
  }
  std::swap(now_, next_);
}

template <class Real>
void FourMomentLattice<Real>::step_inner_row(int y, int z) {
  Neighbours<Real> near;
  for (int dy : {-1, 0, 1})
    for (int dz : {-1, 0, 1})
      near.row[1 + dy][1 + dz] =
          rows_of<const Real>(std::as_const(now_), y + dy, (z + dz + extent_.nz) % extent_.nz);
  stream(near, rows_of<Real>(next_, y, z), extent_.nx);
}

/// Half-way bounce-back: from the wall comes what the cell sent there, with the momentum of the wall.
template <class Real>
void FourMomentLattice<Real>::step_row_at_wall(int y, int z) {
  const auto to = rows_of<Real>(next_, y, z);
  for (int x = 0; x < extent_.nx; ++x) {
    Real sums[4] = {};
    for (int q = 0; q < kQ; ++q) {
      const int from_y = y - e[q].y, from_z = (z - e[q].z + extent_.nz) % extent_.nz;
      const bool from_wall = from_y < 0 || from_y >= extent_.ny;
      const Real wall_speed = from_y < 0 ? -wall_speed_ : wall_speed_;
      const Real value = from_wall
                             ? phi(rows_of<const Real>(std::as_const(now_), y, z), opposite[q], x) +
                                   Real(6 * e[q].x) * wall_speed
                             : phi(rows_of<const Real>(std::as_const(now_), from_y, from_z), q, x - e[q].x);
      const Real weight = Real(d3q19::weight(q));
      sums[0] += weight * value;
      sums[1] += weight * Real(e[q].x) * value;
      sums[2] += weight * Real(e[q].y) * value;
      sums[3] += weight * Real(e[q].z) * value;
    }
    for (int moment = 0; moment < 4; ++moment) to[moment][x] = sums[moment];
  }
}

template class MomentField<float>;
template class MomentField<double>;
template class FourMomentLattice<float>;
template class FourMomentLattice<double>;

}  // namespace capstan
