#pragma once
// The elastic capsule wall: everything it does to the fluid. Units a = k = mu_a = 1: E_s = 1/Ca, E_B = E_b/Ca.
#include <memory>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/membrane/bending.hpp"
#include "solver/membrane/in_plane.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

class Membrane {
 public:
  /// \param reference 3 x #V, the stress-free shape: the capsule's initial one
  Membrane(const Case& c, const TriangleMesh& mesh, const Points& reference);

  /// Forces of the membrane on the fluid, 3 x #V, integrated over each vertex's share. A collapsed triangle
  /// gives numbers that are not finite.
  void forces(const Points& positions, Points& forces) const;

  /// The energy whose negative gradient the forces are; none with bending read literally from eq. 31.
  std::optional<double> energy(const Points& positions) const;

 private:
  InPlaneElasticity in_plane_;
  std::unique_ptr<Bending> bending_;  ///< nothing when E_b = 0
};

}  // namespace capstan
