#include "solver/fluid/paper/level.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "solver/grid/vector_units.hpp"

namespace capstan {

using d3q19::e;
using d3q19::kQ;

/// Workspace of one thread: a row of collided populations, x from -1 to nx, and the row's coefficients.
struct Level::RowBuffer {
  explicit RowBuffer(int nx)
      : length(std::size_t(nx) + 2),
        stride((length + 7) / 8 * 8),
        star(kQ * stride),
        force(3 * stride, 0.0) {}
  double* f_star(int q) { return star.data() + q * stride; }
  /// Post-collision population q of the cell x = 0.
  const double* collided(int q) const { return star.data() + q * stride + 1; }

  std::size_t length, stride;
  std::vector<double> star, force;
  bool force_is_zero = true;  ///< so that rows without a force need not be cleared again
};

namespace {

/// out = keep f + blend (f_star + defect), n cells; a null defect is zero.
CAPSTAN_VECTOR_UNITS void blend_row(double* __restrict out, const double* __restrict f,
                                    const double* __restrict f_star, const double* __restrict defect, int n,
                                    double keep, double blend) {
  if (defect)
    for (int i = 0; i < n; ++i) out[i] = keep * f[i] + blend * (f_star[i] + defect[i]);
  else
    for (int i = 0; i < n; ++i) out[i] = keep * f[i] + blend * f_star[i];
}

}  // namespace

Level::Level(Extent extent, const LevelSettings& settings)
    : settings_(settings),
      transfer_(settings.rates),
      f_(extent),
      scratch_(extent),
      ambient_s_nu_(extent.nx + 2, stress_rate(settings.nu_lu)) {}

// out = keep f + blend (S(f) + D) into scratch_. Every row is collided once and streamed to the up to nine
// rows around it; a ghost row streams inwards. Each population of each cell is written exactly once, by one
// thread.
void Level::sweep(double keep, double blend) {
  fill_ghosts(f_, ghosts_);
  const int nx = extent().nx, ny = extent().ny, nz = extent().nz;
#pragma omp parallel
  {
    RowBuffer row(nx);
#pragma omp for schedule(static)
    for (int z = -1; z <= nz; ++z)
      for (int y = 0; y < ny; ++y) {
        collide_row(y, z, row);
        stream_row(y, z, row, keep, blend);
      }
  }
}

void Level::collide_row(int y, int z, RowBuffer& row) const {
  CollisionRow<double> cells{};
  for (int q = 0; q < kQ; ++q) {
    cells.f[q] = f_[q].row(y, z) - 1;
    cells.f_star[q] = row.f_star(q);
  }
  cells.count = row.length;
  cells.s_nu = s_nu_.empty() ? ambient_s_nu_.data() : s_nu_.row(y, z) - 1;
  gather_force(y, z, row);
  for (int c = 0; c < 3; ++c) cells.force[c] = row.force.data() + c * row.stride;
  collide(cells, settings_.rates, settings_.inertia);
}

/// The force on a row with its ghosts, which are images of cells at the other end (x and z are periodic).
void Level::gather_force(int y, int z, RowBuffer& row) const {
  const auto [nx, ny, nz] = extent();
  const int image_z = (z + nz) % nz;
  const bool inside = force_ && force_->has_row(y, image_z);
  if (!inside && row.force_is_zero) return;
  std::fill(row.force.begin(), row.force.end(), 0.0);
  row.force_is_zero = !inside;
  for (int c = 0; inside && c < 3; ++c) {
    double* force = row.force.data() + c * row.stride + 1;
    std::copy_n(force_->row(c, y, image_z), force_->size()[0], force + force_->lo()[0]);
    force[-1] = force[nx - 1];
    force[nx] = force[0];
  }
}

void Level::stream_row(int y, int z, const RowBuffer& row, double keep, double blend) {
  const auto [nx, ny, nz] = extent();
  for (int q = 0; q < kQ; ++q) {
    const int to_y = y + e[q].y, to_z = z + e[q].z;
    const bool from_ghost = z < 0 || z >= nz;
    if (to_y < 0 || to_y >= ny) {
      if (!from_ghost) bounce_back(q, y, z, row, keep, blend);
    } else if (to_z >= 0 && to_z < nz) {
      blend_row(scratch_[q].row(to_y, to_z), f_[q].row(to_y, to_z), row.collided(q) - e[q].x,
                defect_.empty() ? nullptr : defect_[q].row(to_y, to_z), nx, keep, blend);
    }
  }
}

/// Half-way bounce-back: what would leave comes back reversed, with the momentum of the moving wall.
void Level::bounce_back(int q, int y, int z, const RowBuffer& row, double keep, double blend) {
  const int back = d3q19::opposite[q];
  double* out = scratch_[back].row(y, z);
  const int nx = extent().nx;
  blend_row(out, f_[back].row(y, z), row.collided(q), defect_.empty() ? nullptr : defect_[back].row(y, z), nx,
            keep, blend);
  const double wall_speed = e[q].y > 0 ? settings_.wall_speed : -settings_.wall_speed;
  const double momentum = 6 * d3q19::weight(q) * e[q].x * wall_speed;
  for (int x = 0; momentum != 0 && x < nx; ++x) out[x] -= blend * momentum;
}

void Level::restrict_to(Level& coarse) {
  if (coarse.defect_.empty()) coarse.defect_ = coarse.start_ = PopulationField(coarse.extent());
  transfer_.restrict_state(f_, coarse.start_);
  coarse.f_ = coarse.start_;
  sweep_residual();
  coarse.take_defect(scratch_);
}

/// scratch_ = r(f) = f - S(f) - D
void Level::sweep_residual() { sweep(1, -1); }

/// D_H = r_H(I f) - I' r_h, where r_H is the residual without a defect.
void Level::take_defect(const PopulationField& fine_residual) {
  for (int q = 0; q < kQ; ++q) std::ranges::fill(defect_[q].data(), 0.0);
  sweep_residual();
  transfer_.restrict_residual(fine_residual, defect_);
  for (int q = 0; q < kQ; ++q)
    std::ranges::transform(scratch_[q].data(), defect_[q].data(), defect_[q].data().begin(), std::minus<>());
}

void Level::correct_from(Level& coarse) {
  for (int q = 0; q < kQ; ++q)
    std::ranges::transform(coarse.f_[q].data(), coarse.start_[q].data(), coarse.scratch_[q].data().begin(),
                           std::minus<>());
  transfer_.scale_to_finer(coarse.scratch_);
  fill_ghosts(coarse.scratch_, ghosts_);
  add_interpolated(coarse.scratch_, f_);
}

void Level::set_couette() {
  const auto [nx, ny, nz] = extent();
  const double shear = 2 * settings_.wall_speed / ny, s_nu = stress_rate(settings_.nu_lu);
  for (int q = 0; q < kQ; ++q)
    for (int z = 0; z < nz; ++z)
      for (int y = 0; y < ny; ++y)
        std::fill_n(f_[q].row(y, z), nx, couette_population(q, shear, y + 0.5 - 0.5 * ny, s_nu));
}

void Level::set_viscosity(const ScalarBox& nu_lu) {
  const double ambient = stress_rate(settings_.nu_lu);
  if (s_nu_.empty()) s_nu_ = CellField(extent(), ambient);
  contrast_.for_each_row(
      [&](int y, int z) { std::fill_n(s_nu_.row(y, z) + contrast_.lo()[0], contrast_.size()[0], ambient); });
  contrast_ = nu_lu;
  nu_lu.for_each_row([&](int y, int z) {
    const double* nu = nu_lu.row(0, y, z);
    std::transform(nu, nu + nu_lu.size()[0], s_nu_.row(y, z) + nu_lu.lo()[0], stress_rate);
  });
}

void Level::velocity(VectorBox& box) const {
  const int nx = box.size()[0];
  box.for_each_row([&](int y, int z) {
    for (int c = 0; c < 3; ++c) {
      double* u = box.row(c, y, z);
      std::fill_n(u, nx, 0.0);
      for (int q = 1; q < kQ; ++q) {
        const int e_c = c == 0 ? e[q].x : c == 1 ? e[q].y : e[q].z;
        const double* f = f_[q].row(y, z) + box.lo()[0];
        for (int x = 0; e_c != 0 && x < nx; ++x) u[x] += e_c * f[x];
      }
    }
  });
  if (force_) add_scaled(0.5, *force_, box);
}

double Level::residual_norm() {
  sweep_residual();
  const auto [nx, ny, nz] = extent();
  double sum = 0;
  for (int q = 0; q < kQ; ++q)
    for (int z = 0; z < nz; ++z)
      for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) sum += std::pow(scratch_[q].row(y, z)[x], 2);
  return std::sqrt(sum / double(kQ * extent().cells()));
}

std::vector<Level> make_levels(Extent extent, const LevelSettings& finest) {
  std::vector<Level> levels;
  LevelSettings settings = finest;
  const auto can_halve = [](int n) { return n % 2 == 0 && n >= 8; };
  levels.emplace_back(extent, settings);
  while (can_halve(extent.nx) && can_halve(extent.ny) && can_halve(extent.nz)) {
    extent = extent.halved();
    settings.inertia *= 2;
    levels.emplace_back(extent, settings);
  }
  return levels;
}

}  // namespace capstan
