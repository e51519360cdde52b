#include "solver/case/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "solver/case/grid_size.hpp"
#include "solver/case/time_step_defaults.hpp"

namespace capstan {
namespace {

struct Rung {
  int nodes;
  double box_parts;    ///< 12.8 / dx of a lattice
  double usual_error;  ///< estimated error of Q, median of random scenes (studies/calibration)
};

constexpr Rung kStokes[] = {{42, 0, 0.1},     {92, 0, 0.05},     {162, 0, 0.025},
                            {362, 0, 0.006},  {642, 0, 0.003},   {1442, 0, 0.0015},
                            {2562, 0, 0.001}, {5762, 0, 0.0009}, {10242, 0, 0.0008}};
constexpr Rung kLattice[] = {{162, 32, 0.2},    {362, 48, 0.1},    {642, 64, 0.05},    {1442, 96, 0.03},
                             {2562, 128, 0.02}, {5762, 192, 0.01}, {10242, 256, 0.005}};

/// The rungs from the coarsest to the finest.
std::span<const Rung> rungs_of(const Case& c) {
  if (c.has_grid()) return kLattice;
  return kStokes;
}

bool fits_box(const Case& c) { return !c.has_grid() || issue_of_grid(c).empty(); }

void set_spacing(Case& c, double dx) {
  const double before = c.fidelity.dx;
  c.fidelity.dx = dx;
  adapt_tolerance(c, before);
}

Case at(const Case& c, const Rung& rung) {
  constexpr double kBox = 12.8;
  Case result = c;
  result.fidelity.nodes = rung.nodes;
  if (c.has_grid()) set_spacing(result, kBox / rung.box_parts);
  choose_time_step(result);
  return result;
}

}  // namespace

void adapt_tolerance(Case& c, double spacing_before) {
  double& tolerance = c.fidelity.tolerance;
  if (c.has_composite_grid() && tolerance == usual_tolerance(spacing_before))
    tolerance = usual_tolerance(c.fidelity.dx);
}

bool has_ladder(const Case& c) { return !c.has_grid() || c.has_composite_grid(); }

std::optional<Case> coarser(const Case& c) {
  if (!has_ladder(c)) return std::nullopt;
  Case result = c;
  result.fidelity.nodes = (c.fidelity.nodes - 2) / 4 + 2;
  set_spacing(result, 2 * c.fidelity.dx);
  const auto rungs = rungs_of(c);
  const bool is_rung = std::ranges::find(rungs, result.fidelity.nodes, &Rung::nodes) != rungs.end();
  if (!is_rung || !fits_box(result)) return std::nullopt;
  choose_time_step(result);
  return result;
}

Case single_run(const Case& c) {
  Case run = c;
  run.companion = false;
  run.fidelity.error = 0;
  return run;
}

std::optional<Case> companion_of(const Case& c) {
  if (!c.companion) return std::nullopt;
  std::optional<Case> companion = coarser(single_run(c));
  if (companion) companion->outputs.shapes_every = 0;
  return companion;
}

Case at_first_rung(const Case& c) {
  Case rung = c;
  for (const Rung& each : rungs_of(c)) {
    rung = at(c, each);
    if (each.usual_error <= c.fidelity.error && fits_box(rung) && coarser(rung)) break;
  }
  return rung;
}

std::optional<Case> next_rung(const Case& rung, std::optional<double> estimate, double asked) {
  constexpr double kMuch = 3;
  int steps = estimate && *estimate > kMuch * asked ? 2 : 1;
  std::optional<Case> next;
  for (const Rung& each : rungs_of(rung)) {
    const Case candidate = at(rung, each);
    if (each.nodes <= rung.fidelity.nodes || !fits_box(candidate) || !coarser(candidate)) continue;
    next = candidate;
    if (--steps == 0) break;
  }
  return next;
}

std::vector<Case> usual_runs(const Case& c) {
  std::vector<Case> runs;
  if (const auto companion = companion_of(c)) runs.push_back(*companion);
  runs.push_back(single_run(c));
  return runs;
}

}  // namespace capstan
