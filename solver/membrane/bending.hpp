#pragma once
// Resistance to bending: two discretisations of Helfrich's energy.
//   E = E_B/2 int (2H - c0)^2 dS,   H = (k1 + k2)/2, positive on a sphere with its outward normal.
// The number c0 of a case is the value of 2H at which the bending energy vanishes: +2 for the unit sphere.
// "initial" is 2H of the initial shape at each vertex (the paper's c0 = -2 kappa_0). The paper's kappa is -H,
// the sign with which its eq. 31 dissipates energy, so 2 kappa + c0 = -(2H - c0). Differs from the paper: eq.
// 30 is printed with 2 kappa - c0, which contradicts eq. 31.
#include <memory>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

class Bending {
 public:
  virtual ~Bending() = default;

  /// Adds the force of the membrane on the fluid at each vertex, 3 x #V.
  virtual void add_forces(const Points& positions, Points& forces) const = 0;

  /// The energy E, where the forces are -dE/dx; nothing if they are not the gradient of an energy.
  virtual std::optional<double> energy(const Points& positions) const = 0;
};

/// #V: c0 at each vertex of the whole surface.
/// \param reference  3 x #V, the initial shape
Scalars spontaneous_curvature(const Case& c, const TriangleMesh& mesh, const Points& reference);

/// The bending model of a case; nullptr if E_b = 0.
/// \param mesh  the surface or a part of it
/// \param spontaneous_curvature c0 at the vertices of `mesh`   \param modulus E_B = E_b a^2 E_s
std::unique_ptr<Bending> make_bending(const Case& c, const TriangleMesh& mesh,
                                      const Scalars& spontaneous_curvature, double modulus);

}  // namespace capstan
