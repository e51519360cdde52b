#include "solver/membrane/membrane.hpp"

namespace capstan {

Membrane::Membrane(const Case& c, const TriangleMesh& mesh, const Points& reference)
    : in_plane_(mesh.faces, reference, make_strain_law(c), 1 / c.Ca),
      bending_(make_bending(c, mesh, reference, c.E_b / c.Ca)) {}

void Membrane::forces(const Points& positions, Points& forces) const {
  forces.setZero(3, positions.cols());
  in_plane_.add_forces(positions, forces);
  if (bending_) bending_->add_forces(positions, forces);
}

std::optional<double> Membrane::energy(const Points& positions) const {
  const std::optional<double> bending = bending_ ? bending_->energy(positions) : 0.0;
  if (!bending) return std::nullopt;
  return in_plane_.energy(positions) + *bending;
}

}  // namespace capstan
