#include "solver/fluid/lbm/lattice_coupling.hpp"

#include <cmath>

namespace capstan {
namespace {

/// The domain is centred on the capsule's initial centre; walls lie half a cell outside of the first cell's
/// centre.
GridGeometry finest_grid(const Fidelity& fidelity) {
  return {Vec3::Constant(-0.5 * (fidelity.box - fidelity.dx)), fidelity.dx};
}

}  // namespace

LatticeCoupling::LatticeCoupling(const Case& c, const TriangleMesh& mesh, const LatticeUnits& units)
    : units_(units),
      cells_(int(std::lround(c.fidelity.box / c.fidelity.dx))),
      contrast_(c.V),
      boundary_(finest_grid(c.fidelity)) {
  if (c.has_viscosity_ratio())
    viscosity_.emplace(finest_grid(c.fidelity), mesh, Orbits::without_symmetry(mesh.vertex_count()));
}

bool LatticeCoupling::place_membrane(const Points& positions, const Points& forces) {
  constexpr int kMargin = 1;  // the jump of viscosity is smoothed over two cells
  if (!boundary_.place(positions, kMargin)) return false;
  for (int c = 0; c < 3; ++c)
    if (boundary_.box_lo()[c] < 0 || boundary_.box_lo()[c] + boundary_.box_size()[c] > cells_) return false;
  force_.reset(boundary_.box_lo(), boundary_.box_size());
  boundary_.spread(forces, units_.force_lu, force_);
  if (viscosity_) {
    nu_.reset(boundary_.box_lo(), boundary_.box_size());
    viscosity_->update(positions, units_.nu_lu, contrast_ * units_.nu_lu, nu_);
  }
  return true;
}

bool LatticeCoupling::put_membrane(const Points& positions, const Points& forces, std::span<Level> levels) {
  if (!place_membrane(positions, forces)) return false;
  levels.front().set_force(&force_);
  if (!viscosity_) return true;
  ScalarBox on_level = nu_;
  for (Level& level : levels) {
    level.set_viscosity(on_level);
    on_level = coarsened(on_level, units_.nu_lu);
  }
  return true;
}

}  // namespace capstan
