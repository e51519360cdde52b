#include "solver/fluid/transient/in_place_lattice.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace capstan {

using d3q19::e;
using d3q19::kQ;
using d3q19::opposite;

/// Force and stress rate along a row, of one thread; rewritten only where the row before or this one has
/// some.
template <class Real>
struct InPlaceLattice<Real>::RowCoefficients {
  RowCoefficients(int nx, double nu_lu) : ambient(Real(stress_rate(nu_lu))), s_nu(nx, ambient) {
    for (auto& component : force) component.assign(nx, 0);
  }

  void gather_force(const VectorBox* box, int y, int z) {
    const bool inside = box && box->has_row(y, z);
    for (int c = 0; c < 3; ++c) {
      if (has_force) std::ranges::fill(force[c], Real(0));
      if (inside) std::copy_n(box->row(c, y, z), box->size()[0], force[c].begin() + box->lo()[0]);
    }
    has_force = inside;
  }

  void gather_viscosity(const ScalarBox* box, int y, int z) {
    const bool inside = box && box->has_row(y, z);
    if (has_contrast) std::ranges::fill(s_nu, ambient);
    if (inside)
      std::transform(box->row(0, y, z), box->row(0, y, z) + box->size()[0], s_nu.begin() + box->lo()[0],
                     [](double nu) { return Real(stress_rate(nu)); });
    has_contrast = inside;
  }

  Real ambient;
  std::vector<Real> s_nu, force[3];
  bool has_force = false, has_contrast = false;
};

namespace {

template <class Real>
constexpr std::size_t kLine = kCacheLine / sizeof(Real);

/// A cache line of padding follows a row, so that the next begins with one. It holds two ghosts: the cell
/// after the row's last, and the cell before the next row's first.
template <class Real>
std::size_t padded_row(int nx) {
  return (nx + kLine<Real> - 1) / kLine<Real> * kLine<Real> + kLine<Real>;
}

/// The 19 arrays lie three cache lines apart modulo 4096 bytes: a multiple of that would put a cell's
/// populations into one and the same set of the cache, and halves the speed.
template <class Real>
std::size_t padded_array(std::size_t rows, std::size_t row_stride) {
  constexpr std::size_t kPage = 4096 / sizeof(Real);
  return (rows * row_stride + kPage - 1) / kPage * kPage + 3 * kLine<Real>;
}

std::vector<double> extent_numbers(Extent extent) {
  return {double(extent.nx), double(extent.ny), double(extent.nz)};
}

}  // namespace

template <class Real>
InPlaceLattice<Real>::InPlaceLattice(Extent extent, const LatticeSettings& settings)
    : settings_(settings),
      extent_(extent),
      row_stride_(padded_row<Real>(extent.nx)),
      array_stride_(padded_array<Real>(std::size_t(extent.ny) * extent.nz, row_stride_)),
      populations_(kLine<Real> + kQ * array_stride_) {}

/// The cell x = 0 of a row.
template <class Real>
Real* InPlaceLattice<Real>::array(int q, int y, int z) {
  const std::size_t row = std::size_t(z) * extent_.ny + y;
  return populations_.data() + kLine<Real> + q * array_stride_ + row * row_stride_;
}

template <class Real>
bool InPlaceLattice<Real>::comes_from_wall(int q, int y) const {
  return y - e[q].y < 0 || y - e[q].y >= extent_.ny;
}

template <class Real>
Real* InPlaceLattice<Real>::place(int q, int y, int z) {
  if (places_ == Places::streamed || comes_from_wall(q, y)) return array(q, y, z);
  return array(opposite[q], y - e[q].y, periodic(z - e[q].z, extent_.nz)) - e[q].x;
}

template <class Real>
void InPlaceLattice<Real>::step() {
  const int rows = extent_.ny * extent_.nz;
#pragma omp parallel
  {
    RowCoefficients coefficients(extent_.nx, settings_.nu_lu);
#pragma omp for schedule(static)
    for (int row = 0; row < rows; ++row) step_row(row % extent_.ny, row / extent_.ny, coefficients);
  }
  places_ = places_ == Places::streamed ? Places::collided : Places::streamed;
}

template <class Real>
void InPlaceLattice<Real>::step_row(int y, int z, RowCoefficients& coefficients) {
  Row row;
  for (int q = 0; q < kQ; ++q) row[q] = place(q, y, z);
  if (places_ == Places::streamed) take_from_ghosts(y, row);
  coefficients.gather_force(force_, y, z);
  coefficients.gather_viscosity(viscosity_, y, z);

  CollisionRow<Real> cells{};
  for (int q = 0; q < kQ; ++q) cells.f[q] = cells.f_star[opposite[q]] = row[q];
  for (int c = 0; c < 3; ++c) cells.force[c] = coefficients.force[c].data();
  cells.s_nu = coefficients.s_nu.data();
  cells.count = extent_.nx;
  collide(cells, settings_.rates, settings_.inertia);

  push_walls(y, row);
  if (places_ == Places::streamed) put_into_ghosts(y, row);
}

/// What came back from a moving wall has its momentum.
template <class Real>
void InPlaceLattice<Real>::push_walls(int y, const Row& row) const {
  for (int q = 0; q < kQ; ++q) {
    if (!comes_from_wall(q, y) || e[q].x == 0) continue;
    const double wall_speed = e[q].y < 0 ? settings_.wall_speed : -settings_.wall_speed;
    const Real momentum = Real(6 * d3q19::weight(q) * e[q].x * wall_speed);
    for (int x = 0; x < extent_.nx; ++x) row[q][x] += momentum;
  }
}

// A population that crossed the end of a row was put beyond it; it is the one of the first cell at the other
// end.
template <class Real>
void InPlaceLattice<Real>::take_from_ghosts(int y, const Row& row) const {
  const int nx = extent_.nx;
  for (int q = 0; q < kQ; ++q)
    if (wraps(q, y)) (e[q].x > 0 ? row[q][0] : row[q][nx - 1]) = e[q].x > 0 ? row[q][nx] : row[q][-1];
}

template <class Real>
void InPlaceLattice<Real>::put_into_ghosts(int y, const Row& row) const {
  const int nx = extent_.nx;
  for (int q = 0; q < kQ; ++q)
    if (wraps(q, y)) (e[q].x > 0 ? row[q][nx] : row[q][-1]) = e[q].x > 0 ? row[q][0] : row[q][nx - 1];
}

template <class Real>
void InPlaceLattice<Real>::read_row(int y, int z, std::vector<Real>& populations) const {
  const int nx = extent_.nx;
  populations.resize(std::size_t(kQ) * nx);
  for (int q = 0; q < kQ; ++q) {
    const Real* from = place(q, y, z);
    Real* to = populations.data() + std::size_t(q) * nx;
    std::copy_n(from, nx, to);
    if (places_ == Places::streamed && wraps(q, y))
      (e[q].x > 0 ? to[0] : to[nx - 1]) = from[e[q].x > 0 ? nx : -1];
  }
}

template <class Real>
void InPlaceLattice<Real>::set_couette() {
  places_ = Places::streamed;
  const auto [nx, ny, nz] = extent_;
  const double shear = 2 * settings_.wall_speed / ny, s_nu = stress_rate(settings_.nu_lu);
  for (int q = 0; q < kQ; ++q)
    for (int z = 0; z < nz; ++z)
      for (int y = 0; y < ny; ++y)
        std::fill_n(array(q, y, z) - 1, nx + 2, Real(couette_population(q, shear, y + 0.5 - 0.5 * ny, s_nu)));
}

// In the order of the directions, in double whatever the populations are.
template <class Real>
void InPlaceLattice<Real>::velocity(VectorBox& box) const {
  const int nx = box.size()[0];
  std::vector<Real> populations;  // of a row
  box.for_each_row([&](int y, int z) {
    read_row(y, z, populations);
    for (int c = 0; c < 3; ++c) {
      double* u = box.row(c, y, z);
      std::fill_n(u, nx, 0.0);
      for (int q = 1; q < kQ; ++q) {
        const double e_c = c == 0 ? e[q].x : c == 1 ? e[q].y : e[q].z;
        const Real* f = populations.data() + std::size_t(q) * extent_.nx + box.lo()[0];
        for (int x = 0; e_c != 0 && x < nx; ++x) u[x] += e_c * double(f[x]);
      }
    }
  });
  if (force_) add_scaled(0.5, *force_, box);
}

template <class Real>
void InPlaceLattice<Real>::save(StateArchive& archive) const {
  archive.put("fluid/extent", extent_numbers(extent_));
  archive.put("fluid/collided", double(places_ == Places::collided));
  if constexpr (std::is_same_v<Real, double>)
    archive.put_view("fluid/f", populations_);
  else
    archive.put("fluid/f", std::vector<double>(populations_.begin(), populations_.end()));
}

template <class Real>
void InPlaceLattice<Real>::load(const StateArchive& archive) {
  const auto data = archive.get("fluid/f");
  if (!std::ranges::equal(archive.get("fluid/extent"), extent_numbers(extent_)) ||
      data.size() != populations_.size())
    throw std::runtime_error("checkpoint entry \"fluid/f\" has another grid");
  std::ranges::transform(data, populations_.begin(), [](double value) { return Real(value); });
  places_ = archive.number("fluid/collided") != 0 ? Places::collided : Places::streamed;
}

template class InPlaceLattice<float>;
template class InPlaceLattice<double>;

}  // namespace capstan
