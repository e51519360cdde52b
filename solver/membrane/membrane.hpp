#pragma once
// Elastic forces of the membrane on the fluid, in units a = k = mu_a = 1: E_s = 1/Ca, E_B = E_b/Ca. For a
// symmetric capsule the forces are computed on a quarter of the membrane and mapped to the rest.
#include <memory>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/membrane/bending.hpp"
#include "solver/membrane/in_plane.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"
#include "solver/mesh/surface_patch.hpp"

namespace capstan {

class Membrane {
 public:
  /// \param reference 3 x #V, the stress-free shape, which is the initial shape
  /// \param orbits    symmetry of the reference; all positions passed to forces() must have it
  Membrane(const Case& c, const TriangleMesh& mesh, const Points& reference, Orbits orbits);

  /// Force of the membrane on the fluid at each vertex, 3 x #V, in units of mu_a k a^2. Not finite if the
  /// positions are not, or if a triangle has collapsed (with bending or the neo-Hookean law).
  void forces(const Points& positions, Points& forces) const;

  /// The elastic energy E, where the forces are -dE/dx. Nothing for the bending model helfrich_literal, whose
  /// forces are not the gradient of an energy, and nothing if only a quarter of the membrane is computed.
  std::optional<double> energy(const Points& positions) const;

 private:
  Orbits orbits_;
  SurfacePatch patch_;  ///< two rings of faces around the representatives
  InPlaneElasticity in_plane_;
  std::unique_ptr<Bending> bending_;  ///< nullptr if E_b = 0
};

}  // namespace capstan
