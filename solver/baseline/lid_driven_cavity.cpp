#include "solver/baseline/lid_driven_cavity.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "solver/fluid/lbm/populations.hpp"
#include "solver/grid/full_approximation.hpp"

namespace capstan {

using d3q19::e;
using d3q19::kQ;
using d3q19::opposite;

namespace {

constexpr int kCoarsestCells = 4;

/// Momentum 6 w_q e_q . u that the lid adds to the population q that leaves it.
double momentum_from_lid(int q, double lid_speed) { return 6 * d3q19::weight(q) * e[q].x * lid_speed; }

/// out = a - b in all cells, ghosts excluded.
void subtract(const RowField<double>& a, const RowField<double>& b, RowField<double>& out) {
  for_each_row(out.box(), [&](int y, int z) {
    for (int q = 0; q < kQ; ++q)
      std::transform(a.row(q, y, z), a.row(q, y, z) + a.box().size(0), b.row(q, y, z), out.row(q, y, z),
                     std::minus<>());
  });
}

/// Ghosts behind the walls: density is even and momentum is odd across each wall, so a ghost at an edge
/// between two walls has the populations of its cell, one behind a single wall those of the opposite
/// directions.
void fill_wall_ghosts(RowField<double>& f) {
  const int n = f.box().size(0);
  const auto inside = [&](int i) { return std::clamp(i, 0, n - 1); };
  const auto is_ghost = [&](int i) { return i != inside(i) ? 1 : 0; };
  for_each_row(grown(f.box(), 1), [&](int y, int z) {
    for (int x = -1; x <= n; ++x) {
      const int walls = is_ghost(x) + is_ghost(y) + is_ghost(z);
      for (int q = 0; walls > 0 && q < kQ; ++q)
        f.row(q, y, z)[x] = f.row(walls % 2 == 1 ? opposite[q] : q, inside(y), inside(z))[inside(x)];
    }
  });
}

}  // namespace

CavityGrid::CavityGrid(int cells, const CavitySettings& settings)
    : settings_(settings),
      transfer_(settings.rates),
      f_(box_from_zero({cells, cells, cells}), kQ, Layout::separate_components),
      collided_(f_),
      next_(f_) {}

void CavityGrid::relax() {
  sweep(1 - settings_.gamma, settings_.gamma);
  std::swap(f_, next_);
}

/// next_ = keep f + blend (S(f) + D)
void CavityGrid::sweep(double keep, double blend) {
  for_each_row(box(), [&](int y, int z) { collide_row(y, z); });
  for_each_row(box(), [&](int y, int z) { stream_row(y, z, keep, blend); });
}

void CavityGrid::collide_row(int y, int z) {
  thread_local std::vector<double> s_nu, no_force;
  const auto n = std::size_t(box().size(0));
  s_nu.assign(n, stress_rate(settings_.nu_lu));
  no_force.assign(n, 0);
  CollisionRow<double> cells{};
  for (int q = 0; q < kQ; ++q) {
    cells.f[q] = f_.row(q, y, z);
    cells.f_star[q] = collided_.row(q, y, z);
  }
  cells.s_nu = s_nu.data();
  std::ranges::fill(cells.force, no_force.data());
  cells.count = n;
  collide(cells, settings_.rates, settings_.inertia);
}

/// A population arrives from the next cell, or from its own cell by half-way bounce-back where a wall is
/// between.
void CavityGrid::stream_row(int y, int z, double keep, double blend) {
  thread_local std::vector<double> arrived;
  const int n = box().size(0);
  arrived.resize(std::size_t(n));
  for (int q = 0; q < kQ; ++q) {
    const int from_y = y - e[q].y, from_z = z - e[q].z;
    const double from_lid = from_y == n ? momentum_from_lid(q, settings_.lid_speed) : 0;
    const double* reflected = collided_.row(opposite[q], y, z);
    for (int x = 0; x < n; ++x) arrived[x] = reflected[x] + from_lid;
    if (box().has_row(from_y, from_z)) {
      const double* streamed = collided_.row(q, from_y, from_z);
      for (int x = std::max(0, e[q].x); x < n + std::min(0, e[q].x); ++x) arrived[x] = streamed[x - e[q].x];
    }
    const double* f = f_.row(q, y, z);
    double* out = next_.row(q, y, z);
    for (int x = 0; x < n; ++x) out[x] = keep * f[x] + blend * arrived[x];
    if (coarse_)
      for (int x = 0; x < n; ++x) out[x] += blend * coarse_->defect.row(q, y, z)[x];
  }
}

void CavityGrid::restrict_to(CavityGrid& coarse) {
  if (!coarse.coarse_) coarse.coarse_.emplace(CoarseProblem{.defect = coarse.f_, .start = coarse.f_});
  transfer_.restrict_state(f_, coarse.coarse_->start);
  coarse.f_ = coarse.coarse_->start;
  sweep(-1, 1);  // next_ = S(f) + D - f, the residual
  coarse.take_defect(next_);
}

/// D_H = A_H(I f) + I' r_h, where -A_H(I f) is the residual with D = 0.
void CavityGrid::take_defect(const RowField<double>& fine_residual) {
  RowField<double>& defect = coarse_->defect;
  std::ranges::fill(defect.data(), 0.0);
  sweep(-1, 1);
  transfer_.restrict_residual(fine_residual, defect);
  subtract(defect, next_, defect);
}

void CavityGrid::correct_from(CavityGrid& coarse) {
  RowField<double>& change = coarse.next_;
  subtract(coarse.f_, coarse.coarse_->start, change);
  transfer_.scale_to_finer(change);
  fill_wall_ghosts(change);
  add_interpolated(change, f_);
}

VectorField CavityGrid::velocity() const {
  VectorField u;
  u.reset(box());
  for_each_row(box(), [&](int y, int z) {
    PopulationRow<const double> f;
    for (int q = 0; q < kQ; ++q) f[q] = f_.row(q, y, z);
    for (int c = 0; c < 3; ++c) momentum_of_row(f, c, box().size(0), u.row(c, y, z));
  });
  return u;
}

double CavityGrid::excess_mass() const {
  double sum = 0;
  for_each_row_in_order(box(), [&](int y, int z) {
    for (int q = 0; q < kQ; ++q)
      for (int x = 0; x < box().size(0); ++x) sum += f_.row(q, y, z)[x];
  });
  return sum;
}

std::vector<CavityGrid> make_cavity_grids(int cells, const CavitySettings& settings) {
  std::vector<CavityGrid> grids;
  CavitySettings on_grid = settings;
  for (int n = cells; n >= kCoarsestCells; n /= 2) {
    grids.emplace_back(n, on_grid);
    on_grid.inertia *= 2;
  }
  return grids;
}

CavityCycles count_cavity_cycles(int cells, double Re, double gamma, const std::vector<double>& tolerances,
                                 int max_cycles) {
  constexpr CycleShape kWCycle{.pre = 1, .post = 1, .visits = 2, .coarsest = 10};
  CavitySettings settings{.gamma = gamma};
  settings.lid_speed = Re * settings.nu_lu / cells;
  std::vector<CavityGrid> grids = make_cavity_grids(cells, settings);
  CavityCycles counted{std::vector<std::optional<int>>(tolerances.size()), 1};
  VectorField last = grids.front().velocity();
  double last_change = 1;
  for (int cycle = 1; cycle <= max_cycles && !counted.until.back(); ++cycle) {
    fas_cycle(std::span(grids), kWCycle);
    VectorField now = grids.front().velocity();
    const double change = relative_difference(now, last);
    if (!std::isfinite(change)) break;
    for (std::size_t i = 0; i < tolerances.size(); ++i)
      if (!counted.until[i] && change <= tolerances[i]) counted.until[i] = cycle;
    counted.contraction = change / last_change;
    last = std::move(now);
    last_change = change;
  }
  return counted;
}

}  // namespace capstan
