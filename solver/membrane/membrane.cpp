#include "solver/membrane/membrane.hpp"

#include <utility>

namespace capstan {
namespace {

/// The bending force at a vertex depends on the curvature at its neighbours, and this curvature on the faces
/// around the neighbours: two rings of faces. helfrich_literal needs the whole surface for its quadric fits.
constexpr int kRings = 2;

}  // namespace

Membrane::Membrane(const Case& c, const TriangleMesh& mesh, const Points& reference, Orbits orbits)
    : orbits_(c.bending == BendingModel::variational ? std::move(orbits)
                                                     : Orbits::without_symmetry(mesh.vertex_count())),
      patch_(patch_around(orbits_.representatives(), kRings, mesh)),
      in_plane_(patch_.mesh.faces, patch_.restrict(reference), *c.law, c.law_constants, 1 / c.Ca),
      bending_(make_bending(c, patch_.mesh, spontaneous_curvature(c, mesh, reference)(patch_.vertices),
                            c.E_b / c.Ca)) {}

void Membrane::forces(const Points& positions, Points& forces) const {
  const Points of_patch = patch_.restrict(positions);
  Points on_patch = Points::Zero(3, of_patch.cols());
  in_plane_.add_forces(of_patch, on_patch);
  if (bending_) bending_->add_forces(of_patch, on_patch);
  forces = orbits_.extend(on_patch);
}

std::optional<double> Membrane::energy(const Points& positions) const {
  if (!orbits_.are_trivial()) return std::nullopt;
  const std::optional<double> bending = bending_ ? bending_->energy(positions) : 0.0;
  if (!bending) return std::nullopt;
  return in_plane_.energy(positions) + *bending;
}

}  // namespace capstan
