#include "solver/case/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "solver/case/grid_size.hpp"
#include "solver/case/limits.hpp"
#include "solver/case/time_step_defaults.hpp"
#include "solver/case/wrinkling.hpp"

namespace capstan {
namespace {

struct Rung {
  int nodes;
  double box_parts;     ///< 12.8 / dx of a lattice
  double usual_error;   ///< of Q as estimated from the next coarser rung; median of random scenes
                        ///< (studies/calibration; lattices with numerics 9)
  double of_red_cells;  ///< the same
};

constexpr Rung kStokes[] = {{42, 0, 0.1, 0.3},        {92, 0, 0.03, 0.2},        {162, 0, 0.007, 0.1},
                            {362, 0, 0.003, 0.017},   {642, 0, 0.0015, 0.007},   {1442, 0, 0.0009, 0.0025},
                            {2562, 0, 0.0008, 0.001}, {5762, 0, 0.0008, 0.0009}, {10242, 0, 0.0008, 0.0008}};
constexpr Rung kLattice[] = {{162, 32, 0.05, 0.1},      {362, 48, 0.02, 0.04},      {642, 64, 0.012, 0.02},
                             {1442, 96, 0.007, 0.01},   {2562, 128, 0.0045, 0.008}, {5762, 192, 0.003, 0.006},
                             {10242, 256, 0.002, 0.004}};

/// The rungs from the coarsest to the finest.
std::span<const Rung> rungs_of(const Case& c) {
  if (c.has_grid()) return kLattice;
  return kStokes;
}

bool fits_box(const Case& c) { return !c.has_grid() || issue_of_grid(c).empty(); }

/// Whether the cells of a lattice fill the box, and the capsule has room in it.
bool is_possible(const Case& c) { return fits_box(c) && (!c.has_grid() || c.fidelity.box >= min_box(c)); }

/// Whether the mesh is too coarse for the wrinkles of a membrane without bending stiffness. Then two coarse
/// runs may agree, and both be wrong.
bool hides_wrinkles(const Case& c) {
  constexpr int kFine = 1442;
  return !c.has_bending() && is_compressed(c) && c.fidelity.nodes < kFine;
}

double usual_error(const Case& c) {
  const Rung& rung = *std::ranges::find(rungs_of(c), c.fidelity.nodes, &Rung::nodes);
  return c.shape == Shape::biconcave ? rung.of_red_cells : rung.usual_error;
}

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

std::optional<Case> rung_below(const Case& c) {
  std::optional<Case> below;
  for (const Rung& each : rungs_of(c)) {
    if (each.nodes >= c.fidelity.nodes) break;
    if (const Case rung = at(c, each); is_possible(rung)) below = rung;
  }
  return below;
}

std::optional<Case> rung_above(const Case& c) {
  for (const Rung& each : rungs_of(c)) {
    if (each.nodes <= c.fidelity.nodes) continue;
    if (const Case rung = at(c, each); is_possible(rung)) return rung;
  }
  return std::nullopt;
}

Case at_expected_rung(const Case& c) {
  Case found = at(c, rungs_of(c).front());
  for (const Rung& each : rungs_of(c)) {
    const Case rung = at(c, each);
    if (!is_possible(rung) || !rung_below(rung)) continue;
    found = rung;
    if (usual_error(rung) <= c.fidelity.error && !hides_wrinkles(rung)) break;
  }
  return found;
}

Case first_of_climb(const Case& c) {
  constexpr double kLargest = 4;
  const auto can_begin_at = [&](const Case& rung) {
    return rung_below(rung) && !hides_wrinkles(rung) && usual_error(rung) <= kLargest * c.fidelity.error;
  };
  Case first = single_run(c);
  for (auto below = rung_below(first); below && can_begin_at(*below); below = rung_below(first))
    first = *below;
  return first;
}

std::vector<Case> usual_runs(const Case& c) {
  std::vector<Case> runs;
  if (c.fidelity.error == 0) {
    if (const auto companion = companion_of(c)) runs.push_back(*companion);
  } else {
    std::optional<Case> rung = rung_below(first_of_climb(c));
    for (; rung && rung->fidelity.nodes < c.fidelity.nodes; rung = rung_above(*rung)) runs.push_back(*rung);
  }
  runs.push_back(single_run(c));
  return runs;
}

}  // namespace capstan
