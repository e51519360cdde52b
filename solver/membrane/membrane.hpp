#pragma once
// The elastic capsule wall: everything it does to the fluid. Units a = k = mu_a = 1: E_s = 1/Ca, E_B =
// E_b/Ca. Of a capsule with symmetry a quarter of the wall is computed, the forces of the rest are its
// images.
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
  /// \param reference 3 x #V, the stress-free shape: the capsule's initial one
  /// \param orbits    of it, and of all positions to come
  Membrane(const Case& c, const TriangleMesh& mesh, const Points& reference, Orbits orbits);

  /// Forces of the membrane on the fluid, 3 x #V, integrated over each vertex's share. A collapsed triangle
  /// gives numbers that are not finite.
  void forces(const Points& positions, Points& forces) const;

  /// The energy whose negative gradient the forces are; none with bending read literally from eq. 31, or of a
  /// quarter.
  std::optional<double> energy(const Points& positions) const;

 private:
  Orbits orbits_;
  SurfacePatch patch_;  ///< with complete rings around the neighbours of the representatives
  InPlaneElasticity in_plane_;
  std::unique_ptr<Bending> bending_;  ///< nothing when E_b = 0
};

}  // namespace capstan
