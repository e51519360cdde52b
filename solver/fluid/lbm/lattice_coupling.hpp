#pragma once
// Coupling of a capsule to a uniform lattice over the whole domain: forces and viscosities onto the cells,
// velocities back to the vertices.
#include <optional>

#include "solver/coupling/immersed_boundary.hpp"
#include "solver/coupling/viscosity_field.hpp"
#include "solver/grid/lattice_units.hpp"

namespace capstan {

/// A cubic domain, periodic in x and z and with walls in y, centred on the initial centre of the capsule.
struct LatticeOptions {
  LatticeUnits units;  ///< among them the spacing
  double box = 12.8;   ///< edge of the domain / a
  double V = 1;        ///< viscosity ratio

  /// All cells of the domain, numbered from 0.
  IndexBox cells() const;
  /// Speed of the upper wall in lattice units: that of the shear flow u_x = y at y = box / 2.
  double wall_speed() const { return 0.5 * box * units.velocity_lu; }
};

class LatticeCoupling {
 public:
  LatticeCoupling(const TriangleMesh& mesh, const LatticeOptions& options);

  /// Computes forces and viscosities in the cells around the membrane. Returns false if a position is not
  /// finite or too close to the boundary of the domain.
  /// \param positions  3 x #V
  /// \param forces     3 x #V, by the membrane on the fluid, units mu_a k a^2
  bool place_membrane(const Points& positions, const Points& forces);

  /// Lattice units.
  const VectorField& force() const { return force_; }
  /// Lattice units. Null for V = 1.
  const ScalarField* viscosity() const { return viscosity_ ? &nu_ : nullptr; }

  /// Velocities of the vertices, 3 x #V, units a k.
  /// \tparam Lattice  has `void velocity(VectorField&) const`, in lattice units
  template <class Lattice>
  void vertex_velocities(const Lattice& lattice, Points& velocities) {
    velocity_.reset(boundary_.box());
    lattice.velocity(velocity_);
    boundary_.interpolate(velocity_, 1 / options_.units.velocity_lu, velocities);
  }

 private:
  LatticeOptions options_;
  ImmersedBoundary boundary_;
  std::optional<ViscosityField> viscosity_;  ///< none for V = 1
  VectorField force_;
  ScalarField nu_;
  VectorField velocity_;  ///< scratch of vertex_velocities()
};

}  // namespace capstan
