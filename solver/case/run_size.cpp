#include "solver/case/run_size.hpp"

#include <cmath>

#include "solver/case/grid_size.hpp"
#include "solver/case/ladder.hpp"

namespace capstan {

/// A file for each shape: positions, velocities, forces and stretches in double precision, and the overhead
/// of HDF5. The triangles are stored once.
double shapes_size(const Case& c) {
  constexpr double kVertex = 10 * 8, kFile = 4104, kFaces = 27;
  if (c.outputs.shapes_every <= 0) return 0;
  const double frames = 1 + std::floor(c.until.kt / c.outputs.shapes_every);
  return kFaces * c.fidelity.nodes + frames * (kVertex * c.fidelity.nodes + kFile);
}

namespace {

/// A line of history.jsonl and a row of the database for each record.
double history_size(const Case& c) {
  constexpr double kLine = 190, kRow = 110;
  return (kLine + kRow) * (1 + c.until.kt / c.outputs.history_every);
}

/// Measured sizes of the membrane's and the flow's state: all cells of a uniform lattice, the cells near the
/// capsule of a composite grid.
double checkpoint_size(const Case& c) {
  constexpr double kVertex = 108, kCell = 190;
  const double membrane = kVertex * c.fidelity.nodes + 10'000;
  if (!c.has_grid()) return membrane;
  return membrane + kCell * (c.has_composite_grid() ? composite_cells(c) : uniform_cells(c));
}

/// Of a composite grid: the fields of the finest level, in single or double precision, and half of them if
/// there is no viscosity field. Of a uniform lattice: populations, and the fields of the coupling.
double grid_memory(const Case& c) {
  constexpr double kLevels = 8e6, kCompositeCell = 1000, kDouble = 1.7, kPapersCell = 620,
                   kTransientCell = 242;
  if (!c.has_grid()) return 0;
  if (c.fluid == Fluid::transient) return kLevels + kTransientCell * uniform_cells(c);
  if (!c.has_composite_grid()) return kLevels + kPapersCell * uniform_cells(c);
  const double precision = c.fidelity.precision == Precision::double_ ? kDouble : 1;
  return kLevels + kCompositeCell * composite_cells(c) * precision * (c.has_viscosity_ratio() ? 1 : 0.5);
}

}  // namespace

double run_size(const Case& c) {
  constexpr double kOthers = 10'000;  // case.json, result.json, log
  double size = kOthers;
  for (const Case& run : usual_runs(c)) size += shapes_size(run) + history_size(run) + checkpoint_size(run);
  return size;
}

double run_memory(const Case& c) {
  constexpr double kProcess = 16.5e6, kVertex = 1900;
  return kProcess + kVertex * c.fidelity.nodes + grid_memory(c);
}

}  // namespace capstan
