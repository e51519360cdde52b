#include "solver/case/run_size.hpp"

#include <cmath>

#include "solver/case/grid_size.hpp"

namespace capstan {

/// Positions, velocities and forces in double precision, and the frame of an HDF5 file; the triangles once.
double shapes_size(const Case& c) {
  constexpr double kVertex = 9 * 8, kFile = 4104, kFaces = 27;
  if (c.outputs.shapes_every <= 0) return 0;
  const double frames = 1 + std::floor(c.until.kt / c.outputs.shapes_every);
  return kFaces * c.fidelity.nodes + frames * (kVertex * c.fidelity.nodes + kFile);
}

namespace {

/// A line of history.jsonl, and a row of the database.
double history_size(const Case& c) {
  constexpr double kLine = 190, kRow = 110;
  return (kLine + kRow) * (1 + c.until.kt / c.outputs.history_every);
}

/// The state of the flow, as measured: of a lattice all its cells, of the composite those of the box around
/// the capsule and of its margins.
double checkpoint_size(const Case& c) {
  constexpr double kVertex = 108, kCell = 190, kCompositeCell = 450;
  const double membrane = kVertex * c.fidelity.nodes + 10'000;
  if (!c.has_grid()) return membrane;
  if (!c.has_composite_grid()) return membrane + kCell * uniform_cells(c);
  return membrane + kCompositeCell * composite_cells(c);
}

}  // namespace

double run_size(const Case& c) {
  constexpr double kOthers = 10'000;  // case.json, result.json, log
  return kOthers + shapes_size(c) + history_size(c) + checkpoint_size(c);
}

}  // namespace capstan
