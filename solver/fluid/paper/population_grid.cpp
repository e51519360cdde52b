#include "solver/fluid/paper/population_grid.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>

#include "solver/fluid/lbm/populations.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {

using d3q19::e;
using d3q19::kQ;
using d3q19::opposite;

/// Scratch of one thread: a row of collided populations and the force on it, ghost cells at both ends
/// included.
struct PopulationGrid::RowBuffer {
  explicit RowBuffer(int nx)
      : length(nx + 2), stride(whole_lines<double>(length)), star(kQ * stride), force(3 * stride) {}

  /// Collided population q from the ghost at x = -1 on.
  double* f_star(int q) { return star.data() + q * stride; }
  /// Collided population q from the cell x = 0 on.
  const double* collided(int q) const { return star.data() + q * stride + 1; }

  int length, stride;
  std::vector<double> star, force;
  bool force_is_zero = true;  ///< whether the force in the buffer is zero, so that it need not be cleared
};

namespace {

constexpr SideRules kSides{{{{SideRule::periodic, SideRule::periodic},
                             {SideRule::wall, SideRule::wall},
                             {SideRule::periodic, SideRule::periodic}}}};

/// The image of a population behind a wall is the population of the opposite direction: density is even and
/// momentum is odd across the wall.
constexpr auto kOppositePopulations = [] {
  std::array<ImageComponent, kQ> image{};
  for (int q = 0; q < kQ; ++q) image[q] = {opposite[q], 1};
  return image;
}();
constexpr Images kPopulationImages = {.wall = kOppositePopulations, .mirror = {}, .half_turn = {}};

/// out = keep f + blend (f_star + defect), n cells. A null defect is zero.
CAPSTAN_VECTOR_UNITS void blend_row(double* __restrict out, const double* __restrict f,
                                    const double* __restrict f_star, const double* __restrict defect, int n,
                                    double keep, double blend) {
  if (defect)
    for (int i = 0; i < n; ++i) out[i] = keep * f[i] + blend * (f_star[i] + defect[i]);
  else
    for (int i = 0; i < n; ++i) out[i] = keep * f[i] + blend * f_star[i];
}

/// out = a - b in all cells, ghosts excluded.
void subtract(const RowField<double>& a, const RowField<double>& b, RowField<double>& out) {
  for_each_row(out.box(), [&](int y, int z) {
    for (int q = 0; q < kQ; ++q)
      std::transform(a.row(q, y, z), a.row(q, y, z) + a.box().size(0), b.row(q, y, z), out.row(q, y, z),
                     std::minus<>());
  });
}

}  // namespace

PopulationGrid::PopulationGrid(const IndexBox& box, const PopulationGridSettings& settings)
    : settings_(settings),
      transfer_(settings.rates),
      f_(box, kQ, Layout::separate_components),
      ambient_s_nu_(box.size(0) + 2, stress_rate(settings.nu_lu)),
      next_(f_) {
  assert(box == box_from_zero(box.hi));
}

// next_ = keep f + blend (S(f) + D). Every row is collided once and streamed to itself and to the rows around
// it, nine in the interior; a ghost row of z streams into the domain only. Each population of each cell is
// written once, by one thread.
void PopulationGrid::sweep(double keep, double blend) {
  fill_ghosts(f_, kSides, kPopulationImages);
  const int nx = box().size(0), ny = box().size(1), nz = box().size(2);
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

void PopulationGrid::collide_row(int y, int z, RowBuffer& row) const {
  CollisionRow<double> cells{};
  for (int q = 0; q < kQ; ++q) {
    cells.f[q] = f_.row(q, y, z) - 1;
    cells.f_star[q] = row.f_star(q);
  }
  cells.count = std::size_t(row.length);
  cells.s_nu = s_nu_ ? s_nu_->row(0, y, z) - 1 : ambient_s_nu_.data();
  gather_force(y, z, row);
  for (int c = 0; c < 3; ++c) cells.force[c] = row.force.data() + c * row.stride;
  collide(cells, settings_.rates, settings_.inertia);
}

/// Writes the force on a row into the buffer. Ghosts at its ends and ghost rows of z have the force of the
/// cells of which they are periodic images.
void PopulationGrid::gather_force(int y, int z, RowBuffer& row) const {
  const auto [nx, ny, nz] = box().hi;
  const int image_z = periodic(z, nz);
  const bool has_force = force_ && force_->box().has_row(y, image_z);
  if (!has_force && row.force_is_zero) return;
  std::fill(row.force.begin(), row.force.end(), 0.0);
  row.force_is_zero = !has_force;
  for (int c = 0; has_force && c < 3; ++c) {
    double* force = row.force.data() + c * row.stride + 1;
    std::copy_n(force_->row(c, y, image_z), force_->box().size(0), force + force_->box().lo[0]);
    force[-1] = force[nx - 1];
    force[nx] = force[0];
  }
}

void PopulationGrid::stream_row(int y, int z, const RowBuffer& row, double keep, double blend) {
  const auto [nx, ny, nz] = box().hi;
  for (int q = 0; q < kQ; ++q) {
    const int to_y = y + e[q].y, to_z = z + e[q].z;
    const bool is_ghost = z < 0 || z >= nz;
    if (to_y < 0 || to_y >= ny) {
      if (!is_ghost) bounce_back(q, y, z, row, keep, blend);
    } else if (to_z >= 0 && to_z < nz) {
      blend_row(next_.row(q, to_y, to_z), f_.row(q, to_y, to_z), row.collided(q) - e[q].x,
                defect_row(q, to_y, to_z), nx, keep, blend);
    }
  }
}

/// Half-way bounce-back: a population that would cross the wall returns to its cell in the opposite
/// direction, with the momentum of the wall added.
void PopulationGrid::bounce_back(int q, int y, int z, const RowBuffer& row, double keep, double blend) {
  const int back = opposite[q], nx = box().hi[0];
  double* out = next_.row(back, y, z);
  blend_row(out, f_.row(back, y, z), row.collided(q), defect_row(back, y, z), nx, keep, blend);
  const double momentum = momentum_from_wall(back, settings_.wall_speed);
  for (int x = 0; momentum != 0 && x < nx; ++x) out[x] += blend * momentum;
}

void PopulationGrid::restrict_to(PopulationGrid& coarse) {
  if (!coarse.coarse_) coarse.coarse_.emplace(CoarseProblem{.defect = coarse.f_, .start = coarse.f_});
  transfer_.restrict_state(f_, coarse.coarse_->start);
  coarse.f_ = coarse.coarse_->start;
  sweep_residual();
  coarse.take_defect(next_);
}

/// next_ = r(f) = S(f) + D - f
void PopulationGrid::sweep_residual() { sweep(-1, 1); }

/// D_H = A_H(I f) + I' r_h, where -A_H(I f) is the residual with D = 0.
void PopulationGrid::take_defect(const RowField<double>& fine_residual) {
  RowField<double>& defect = coarse_->defect;
  std::ranges::fill(defect.data(), 0.0);
  sweep_residual();
  transfer_.restrict_residual(fine_residual, defect);
  subtract(defect, next_, defect);
}

void PopulationGrid::correct_from(PopulationGrid& coarse) {
  RowField<double>& change = coarse.next_;
  subtract(coarse.f_, coarse.coarse_->start, change);
  transfer_.scale_to_finer(change);
  fill_ghosts(change, kSides, kPopulationImages);
  add_interpolated(change, f_);
}

void PopulationGrid::set_couette() {
  const int nx = box().size(0), ny = box().size(1);
  const double shear = 2 * settings_.wall_speed / ny, s_nu = stress_rate(settings_.nu_lu);
  for_each_row(box(), [&](int y, int z) {
    for (int q = 0; q < kQ; ++q)
      std::fill_n(f_.row(q, y, z), nx, couette_population(q, shear, y + 0.5 - 0.5 * ny, s_nu));
  });
}

void PopulationGrid::set_viscosity(const ScalarField& nu_lu) {
  const double ambient = stress_rate(settings_.nu_lu);
  if (!s_nu_) {
    s_nu_.emplace(box(), 1);
    std::ranges::fill(s_nu_->data(), ambient);
  }
  const IndexBox old = std::exchange(viscosity_box_, nu_lu.box()), &now = nu_lu.box();
  for_each_row(old,
               [&](int y, int z) { std::fill_n(s_nu_->row(0, y, z) + old.lo[0], old.size(0), ambient); });
  for_each_row(now, [&](int y, int z) {
    const double* nu = nu_lu.row(0, y, z);
    std::transform(nu, nu + now.size(0), s_nu_->row(0, y, z) + now.lo[0], stress_rate);
  });
}

void PopulationGrid::velocity(VectorField& u) const {
  for_each_row_in_order(u.box(), [&](int y, int z) {
    PopulationRow<const double> f;
    for (int q = 0; q < kQ; ++q) f[q] = f_.row(q, y, z) + u.box().lo[0];
    for (int c = 0; c < 3; ++c) momentum_of_row(f, c, u.box().size(0), u.row(c, y, z));
  });
  if (force_) add_scaled(0.5, *force_, u);
}

double PopulationGrid::residual_norm() {
  sweep_residual();
  double sum = 0;
  for_each_row_in_order(box(), [&](int y, int z) {
    for (int q = 0; q < kQ; ++q)
      for (int x = 0; x < box().size(0); ++x) sum += std::pow(next_.row(q, y, z)[x], 2);
  });
  return std::sqrt(sum / double(kQ * box().cells()));
}

std::vector<PopulationGrid> make_population_grids(const IndexBox& finest,
                                                  const PopulationGridSettings& settings) {
  std::vector<PopulationGrid> grids;
  PopulationGridSettings on_grid = settings;
  const auto can_halve = [](const IndexBox& box) {
    return std::ranges::all_of(box.hi, [](int n) { return n % 2 == 0 && n >= 8; });
  };
  IndexBox box = finest;
  grids.emplace_back(box, on_grid);
  while (can_halve(box)) {
    box = coarsened(box);
    on_grid.inertia *= 2;
    grids.emplace_back(box, on_grid);
  }
  return grids;
}

}  // namespace capstan
