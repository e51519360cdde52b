#pragma once
// Resistance to bending: two discretisations of Helfrich's energy.
//   E = E_B/2 int (2H - c0)^2 dS,   H = (k1 + k2)/2, positive on a sphere with its outward normal.
// The paper's kappa is -H (the sign that makes its eq. 31 dissipative), so 2 kappa + c0 = -(2H - c0): a
// number c0 of a case is the value of 2H that is free of bending, +2 for the unit sphere, and "initial" (the
// paper's c0 = -2 kappa_0) is 2H of the initial shape, vertex by vertex. Differs from the paper: eq. 30 is
// printed with 2 kappa - c0, which contradicts eq. 31.
#include <memory>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

class Bending {
 public:
  virtual ~Bending() = default;

  /// Adds the force of the membrane on the fluid at each vertex.
  virtual void add_forces(const Points& positions, Points& forces) const = 0;

  /// The energy whose negative gradient the forces are, if there is one.
  virtual std::optional<double> energy(const Points& positions) const = 0;
};

/// #V: c0 of a case on its whole surface. \param reference 3 x #V, for c0 "initial" and its mean
Scalars spontaneous_curvature(const Case& c, const TriangleMesh& mesh, const Points& reference);

/// The model a case asks for, nothing if it has no bending. \param mesh the surface or a part of it
/// \param spontaneous_curvature of its vertices   \param modulus E_B = E_b a^2 E_s
std::unique_ptr<Bending> make_bending(const Case& c, const TriangleMesh& mesh,
                                      const Scalars& spontaneous_curvature, double modulus);

}  // namespace capstan
