#pragma once
// Forces of the membrane to the finest grid and velocities of the grid to the membrane, to second order in
// dx: the sharpened kernel (sharpening.hpp), the terms for slip, tension and kink (membrane_layer.hpp), and
// the volume.
//
// Volume: the discrete flow through the membrane is not exactly 0, and a uniform pressure inside does not
// exactly leave the fluid at rest. So the mean pressure <f.n> is taken out of the forces before they are
// spread, and the mean velocity along n out of the velocities that are read; these two projections are
// adjoint to each other. A small uniform velocity returns the volume to its initial value.
#include <optional>

#include "solver/coupling/membrane_layer.hpp"
#include "solver/fluid/quasisteady/symmetric_boundary.hpp"

namespace capstan {

static_assert(kLayerReach <= kSharpeningReach, "the kernels reach beyond the jump of the viscosity");

class MembraneCoupling {
 public:
  /// \param V       viscosity ratio
  /// \param volume  that is kept; none: only the flow through the membrane is zero
  MembraneCoupling(const GridGeometry& grid, const TriangleMesh& mesh, Orbits orbits, double V,
                   std::optional<double> volume);

  bool has_symmetry() const { return boundary_.has_symmetry(); }

  /// To be called first. Returns false if a position (3 x #V) is not finite.
  bool place(const Points& positions);

  /// The cells that the membrane touches, the smoothed jump of the viscosity included.
  IndexBox touched() const { return boundary_.touched(); }

  /// field = scale * the force on each cell.
  /// \param forces  3 x #V, by the membrane on the fluid
  void spread(const Points& forces, double scale, VectorField& field);

  /// The velocities of the vertices, 3 x #V, in the flow `field` plus (y, 0, 0), under the forces of the last
  /// spread().
  void read(const VectorField& field, Points& velocities);

  /// The flow through the membrane that the last read() took out, as a share of the volume per unit of kt. Up
  /// to 0.05 in stable runs; larger where the steps are too long for the membrane, as the volume would drift
  /// then.
  double leak() const { return leak_; }

 private:
  Points tangential(const Points& vectors) const;
  bool has_dipoles() const { return corrections_.slip != 0; }
  Points of_dipoles(const Points& vectors) const;

  double dx_;
  Faces faces_;
  std::optional<double> volume_;
  LayerCorrections corrections_;
  SymmetricBoundary boundary_;
  // Of the present positions and forces
  Points positions_, normals_, area_vectors_;  ///< 3 x #V
  double area_ = 0;                            ///< sum of |N_i|
  double present_volume_ = 0;
  double leak_ = 0;
  Points kinks_;  ///< 3 x #V: the velocities by which kinks are corrected
};

}  // namespace capstan
