#pragma once
// Between a capsule and the finest lattice: forces and viscosities onto the cells, velocities back to the
// vertices.
#include <optional>

#include "solver/case/units.hpp"
#include "solver/coupling/immersed_boundary.hpp"
#include "solver/coupling/viscosity_field.hpp"
#include "solver/fluid/paper/level.hpp"

namespace capstan {

class LatticeCoupling {
 public:
  LatticeCoupling(const Case& c, const TriangleMesh& mesh, const LatticeUnits& units);

  /// Forces and viscosities in the cells around the membrane. False when a position is not finite or too
  /// close to the boundary of the domain.
  bool place_membrane(const Points& positions, const Points& forces);
  const VectorBox& force() const { return force_; }
  /// Null for V = 1.
  const ScalarBox* viscosity() const { return viscosity_ ? &nu_ : nullptr; }

  /// The same, put onto the levels, finest first.
  bool put_membrane(const Points& positions, const Points& forces, std::span<Level> levels);

  /// Velocities of the vertices, units of a k.
  template <class Lattice>  // Level, InPlaceLattice
  void vertex_velocities(const Lattice& finest, Points& velocities) {
    velocity_.reset(boundary_.box_lo(), boundary_.box_size());
    finest.velocity(velocity_);
    boundary_.interpolate(velocity_, 1 / units_.velocity_lu, velocities);
  }

 private:
  LatticeUnits units_;
  int cells_;        ///< along an edge of the domain
  double contrast_;  ///< V
  ImmersedBoundary boundary_;
  std::optional<ViscosityField> viscosity_;  ///< none for V = 1
  VectorBox force_, velocity_;
  ScalarBox nu_;
};

}  // namespace capstan
