#include "solver/fluid/lbm/lattice_coupling.hpp"

#include <cmath>

namespace capstan {
namespace {

/// The walls are half a spacing outside of the centres of the outermost cells.
GridGeometry geometry(const LatticeOptions& options) {
  return {Vec3::Constant(-0.5 * (options.box - options.units.dx)), options.units.dx};
}

}  // namespace

IndexBox LatticeOptions::cells() const {
  const int n = int(std::lround(box / units.dx));
  return box_from_zero({n, n, n});
}

LatticeCoupling::LatticeCoupling(const TriangleMesh& mesh, const LatticeOptions& options)
    : options_(options), boundary_(geometry(options)) {
  if (options.V != 1)
    viscosity_.emplace(geometry(options), mesh, Orbits::without_symmetry(mesh.vertex_count()));
}

bool LatticeCoupling::place_membrane(const Points& positions, const Points& forces) {
  constexpr int kMargin = 1;  // the jump of the viscosity is smoothed over two cells on either side
  if (!boundary_.place(positions, kMargin)) return false;
  if (!options_.cells().contains(boundary_.box())) return false;
  force_.reset(boundary_.box());
  boundary_.spread(forces, options_.units.force_lu, force_);
  if (viscosity_) {
    const double ambient = options_.units.nu_lu;
    nu_.reset(boundary_.box());
    viscosity_->update(positions, smoothed_jump(options_.V * ambient, ambient), nu_);
  }
  return true;
}

}  // namespace capstan
