#include "solver/fluid/transient/in_place_lattice.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <type_traits>

#include "solver/grid/for_each_row.hpp"

namespace capstan {

using d3q19::e;
using d3q19::kQ;
using d3q19::opposite;

/// Scratch of one thread: force and relaxation rate of the stress in the cells of a row. Rewritten only if
/// this row or the one before has a force or another viscosity than the ambient one.
template <class Real>
struct InPlaceLattice<Real>::RowCoefficients {
  RowCoefficients(int nx, double nu_lu) : ambient(Real(stress_rate(nu_lu))), s_nu(nx, ambient) {
    for (auto& component : force) component.assign(nx, 0);
  }

  void gather_force(const VectorField* field, int y, int z) {
    const bool has_row = field && field->box().has_row(y, z);
    for (int c = 0; c < 3; ++c) {
      if (has_force) std::ranges::fill(force[c], Real(0));
      if (has_row)
        std::copy_n(field->row(c, y, z), field->box().size(0), force[c].begin() + field->box().lo[0]);
    }
    has_force = has_row;
  }

  void gather_viscosity(const ScalarField* field, int y, int z) {
    const bool has_row = field && field->box().has_row(y, z);
    if (has_viscosity) std::ranges::fill(s_nu, ambient);
    if (has_row)
      std::transform(field->row(0, y, z), field->row(0, y, z) + field->box().size(0),
                     s_nu.begin() + field->box().lo[0], [](double nu) { return Real(stress_rate(nu)); });
    has_viscosity = has_row;
  }

  Real ambient;
  std::vector<Real> s_nu, force[3];
  bool has_force = false, has_viscosity = false;  ///< whether the row before had them
};

namespace {

template <class Real>
constexpr std::size_t kLine = kNumbersPerLine<Real>;

/// Distance from a row to the next, in numbers. Rows start at cache lines. The extra line of padding between
/// two rows holds two ghosts: the one after the last cell of a row, and the one before the first cell of the
/// next row.
template <class Real>
std::size_t padded_row(int nx) {
  return whole_lines<Real>(nx) + kLine<Real>;
}

/// Distance from one of the 19 arrays to the next, in numbers: a multiple of 4096 bytes plus three cache
/// lines. Without these lines all populations of a cell would be in the same set of the cache, which would
/// halve the speed.
template <class Real>
std::size_t padded_array(std::size_t rows, std::size_t row_stride) {
  constexpr std::size_t kPage = 4096 / sizeof(Real);
  return (rows * row_stride + kPage - 1) / kPage * kPage + 3 * kLine<Real>;
}

std::vector<double> sizes_of(const IndexBox& box) { return {box.hi.begin(), box.hi.end()}; }

}  // namespace

template <class Real>
InPlaceLattice<Real>::InPlaceLattice(const IndexBox& box, const LatticeSettings& settings)
    : settings_(settings),
      box_(box),
      row_stride_(padded_row<Real>(box.size(0))),
      array_stride_(padded_array<Real>(std::size_t(box.size(1)) * box.size(2), row_stride_)),
      populations_(kLine<Real> + kQ * array_stride_) {
  assert(box == box_from_zero(box.hi));
}

/// The cell x = 0 of a row in the array of the direction q.
template <class Real>
Real* InPlaceLattice<Real>::array(int q, int y, int z) {
  const std::size_t row = std::size_t(z) * box_.size(1) + y;
  return populations_.data() + kLine<Real> + q * array_stride_ + row * row_stride_;
}

/// Whether the population q that streams into the row y comes from the wall (half-way bounce-back).
template <class Real>
bool InPlaceLattice<Real>::comes_from_wall(int q, int y) const {
  return y - e[q].y < 0 || y - e[q].y >= box_.size(1);
}

/// Address of the population q that streams into the cell x = 0 of a row; those of the next cells follow.
template <class Real>
Real* InPlaceLattice<Real>::population(int q, int y, int z) {
  if (storage_ == Storage::streamed || comes_from_wall(q, y)) return array(q, y, z);
  return array(opposite[q], y - e[q].y, periodic(z - e[q].z, box_.size(2))) - e[q].x;
}

template <class Real>
void InPlaceLattice<Real>::step() {
  const int ny = box_.size(1), rows = ny * box_.size(2);
#pragma omp parallel
  {
    RowCoefficients coefficients(box_.size(0), settings_.nu_lu);
#pragma omp for schedule(static)
    for (int row = 0; row < rows; ++row) step_row(row % ny, row / ny, coefficients);
  }
  storage_ = storage_ == Storage::streamed ? Storage::collided : Storage::streamed;
}

template <class Real>
void InPlaceLattice<Real>::step_row(int y, int z, RowCoefficients& coefficients) {
  Row row;
  for (int q = 0; q < kQ; ++q) row[q] = population(q, y, z);
  if (storage_ == Storage::streamed) take_from_ghosts(y, row);
  coefficients.gather_force(force_, y, z);
  coefficients.gather_viscosity(viscosity_, y, z);

  CollisionRow<Real> cells{};
  for (int q = 0; q < kQ; ++q) cells.f[q] = cells.f_star[opposite[q]] = row[q];
  for (int c = 0; c < 3; ++c) cells.force[c] = coefficients.force[c].data();
  cells.s_nu = coefficients.s_nu.data();
  cells.count = std::size_t(box_.size(0));
  collide(cells, settings_.rates, settings_.inertia);

  add_momentum_from_walls(y, row);
  if (storage_ == Storage::streamed) put_into_ghosts(y, row);
}

template <class Real>
void InPlaceLattice<Real>::add_momentum_from_walls(int y, const Row& row) const {
  for (int q = 0; q < kQ; ++q) {
    if (!comes_from_wall(q, y) || e[q].x == 0) continue;
    const Real momentum = Real(momentum_from_wall(q, settings_.wall_speed));
    for (int x = 0; x < box_.size(0); ++x) row[q][x] += momentum;
  }
}

// The two ghosts of a row make it periodic. A step that starts with storage `collided` reads and writes
// ghosts like cells, so a population that crosses the end of a row is left in the ghost there. A step that
// starts with storage `streamed` therefore copies it to the cell at the other end before the collision, and
// back to the ghost afterwards.
template <class Real>
void InPlaceLattice<Real>::take_from_ghosts(int y, const Row& row) const {
  const int nx = box_.size(0);
  for (int q = 0; q < kQ; ++q)
    if (wraps(q, y)) (e[q].x > 0 ? row[q][0] : row[q][nx - 1]) = e[q].x > 0 ? row[q][nx] : row[q][-1];
}

template <class Real>
void InPlaceLattice<Real>::put_into_ghosts(int y, const Row& row) const {
  const int nx = box_.size(0);
  for (int q = 0; q < kQ; ++q)
    if (wraps(q, y)) (e[q].x > 0 ? row[q][nx] : row[q][-1]) = e[q].x > 0 ? row[q][0] : row[q][nx - 1];
}

template <class Real>
void InPlaceLattice<Real>::read_row(int y, int z, std::vector<Real>& populations) const {
  const int nx = box_.size(0);
  populations.resize(std::size_t(kQ) * nx);
  for (int q = 0; q < kQ; ++q) {
    const Real* from = population(q, y, z);
    Real* to = populations.data() + std::size_t(q) * nx;
    std::copy_n(from, nx, to);
    if (storage_ == Storage::streamed && wraps(q, y))
      (e[q].x > 0 ? to[0] : to[nx - 1]) = from[e[q].x > 0 ? nx : -1];
  }
}

template <class Real>
void InPlaceLattice<Real>::set_couette() {
  storage_ = Storage::streamed;
  const int nx = box_.size(0), ny = box_.size(1);
  const double shear = 2 * settings_.wall_speed / ny, s_nu = stress_rate(settings_.nu_lu);
  for_each_row_in_order(box_, [&](int y, int z) {
    for (int q = 0; q < kQ; ++q)
      std::fill_n(array(q, y, z) - 1, nx + 2, Real(couette_population(q, shear, y + 0.5 - 0.5 * ny, s_nu)));
  });
}

template <class Real>
void InPlaceLattice<Real>::velocity(VectorField& u) const {
  std::vector<Real> populations;
  for_each_row_in_order(u.box(), [&](int y, int z) {
    read_row(y, z, populations);
    PopulationRow<const Real> f;
    for (int q = 0; q < kQ; ++q) f[q] = populations.data() + std::size_t(q) * box_.size(0) + u.box().lo[0];
    for (int c = 0; c < 3; ++c) momentum_of_row(f, c, u.box().size(0), u.row(c, y, z));
  });
  if (force_) add_scaled(0.5, *force_, u);
}

template <class Real>
void InPlaceLattice<Real>::save(StateArchive& archive) const {
  archive.put("fluid/extent", sizes_of(box_));
  archive.put("fluid/collided", double(storage_ == Storage::collided));
  if constexpr (std::is_same_v<Real, double>)
    archive.put_view("fluid/f", populations_);
  else
    archive.put("fluid/f", std::vector<double>(populations_.begin(), populations_.end()));
}

template <class Real>
void InPlaceLattice<Real>::load(const StateArchive& archive) {
  const auto data = archive.get("fluid/f");
  if (!std::ranges::equal(archive.get("fluid/extent"), sizes_of(box_)) || data.size() != populations_.size())
    throw std::runtime_error("checkpoint entry \"fluid/f\" has another grid");
  std::ranges::transform(data, populations_.begin(), [](double value) { return Real(value); });
  storage_ = archive.number("fluid/collided") != 0 ? Storage::collided : Storage::streamed;
}

template class InPlaceLattice<float>;
template class InPlaceLattice<double>;

}  // namespace capstan
