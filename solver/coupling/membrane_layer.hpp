#pragma once
// The viscosity around the membrane, and the terms that cancel the errors of first order in dx that the
// immersed boundary method makes there.
//
// Near the membrane everything varies along its normal n only, on the scale of a cell. Units: dx = 1 and mu_a
// = 1 in this derivation. Let z be the distance along n, positive outside, f the tangential force per area of
// the membrane on the fluid, f_n the normal one, tau the mean shear stress, p(z) the kernel after sharpening
// (sharpening.hpp) and P its integral. With the viscosity ratio R(z) the fluid moves with
//   u'(z) = (tau - f (P - 1/2)) / R(z)
// along the membrane. A sharp membrane has the same with Heaviside functions. What differs, to first order:
//
// Viscosity. Two integrals over z count: that of 1/R, for the shear across the membrane, and that of R, for
// the stress along it, where the strain rate is continuous. A smoothed jump cannot have the right value of
// both, and a lattice passes stress on to the next cells. So for V > 1 there is more viscosity on the viscous
// side, and more fluidity 1/R on the thin side:
//   1/R(z) = 1/[V^(1-H) + viscosity (V - 1) e b_v(z)] + fluidity (1 - 1/V) e b_f(z)
// with the smoothed Heaviside function H of z - 0.1 (eq. 41, 0.6 cells on either side) and bumps b of
// integral 1, for -1.15 < z < 0.15 and 0 < z < 2. With the right `viscosity` and `fluidity` no stress along
// the membrane is missing, and no shear stress makes the outer fluid slip.
//
// These two conditions leave the shape of the jump and of the bumps free. The shape determines the error of
// second order in dx. It was found by search: of more than a hundred shapes this one has the smallest errors
// of D_xy and theta at dx = 0.2 a, over eleven capsules of V = 3 to 12. The factor e = exp(2 kappa z) with
// the mean curvature kappa, 1 on a flat membrane, was found in the same way. studies/flat_membrane/README.md
// has the errors, also those of capsules that were not part of the search.
//
// Slip. Where the kernel overlaps both fluids, f makes the outer fluid slip by a distance that is
// proportional to f. Force dipoles cancel it. Instead of the force F of a vertex, F - div [s (F_t n + n F_t)]
// is spread, with s = slip dx. The velocity that is read is wrong by the transpose of this slip, so that
//   s (I - n n) (grad u + grad u^T) n
// is added to the velocity of a vertex, the undisturbed flow included.
//
// Tension. Across the jump f_n leaves a stress along the membrane, as a surface tension would do. The dipole
// - div [2 t F_n n n], t = tension dx, cancels it, and
//   2 t n (n.grad u n)
// is added to the velocity. These terms and those of s are adjoint. The dipoles exert neither force nor
// torque; rigid motion has no such gradient.
//
// Kink. The kernel rounds the kink of the velocity off: u_read = u - C f dx / mu_a. C f dx is added as
//   C/psi dx^2 (I - n n) I[S F_t] / mu_a,   psi = int p_0^2 dz,
// with the kernel p_0 that is not sharpened, spreading S and interpolating I: then it has the smoothness of
// the velocity, and needs no area of a vertex. The sum over F_t . I[S F_t] is the integral of the square of
// S F_t: the power is never negative if C is not.
//
// The constants solve the equations of the lattice (link_sweep.hpp) around a flat membrane:
// studies/flat_membrane. They are means over the position of the membrane between the planes of cells and
// over the surface of a sphere in shear flow, for nine classes of directions of n. At V = 1, where R is 1, C
// alone is left, 0.128. For V < 1 the more viscous fluid is outside, and the layer is the mirror image of
// that for 1/V:
//   R(z, kappa; V) = V R(-z, -kappa; 1/V),   s(V) = -s(1/V),   t(V) = -t(1/V),   C(V) = C(1/V)/V.
// Above V = 20 and below 0.05 the equations give a negative C; 0 is used instead.
//
// What is left of first order (columns on the right of studies/flat_membrane/results.md) differs from one
// direction of n to the other. At V = 5, root mean squares: a strain along the membrane makes the fluid slip
// by 0.06 to 0.11 times its rate, C varies by 0.006, and the stress along the membrane is too small or too
// large by that of a layer 0.04 to 0.07 cells thick.
#include "solver/coupling/viscosity_field.hpp"

namespace capstan {

/// R for the viscosity ratio V.
ViscosityProfile layer_viscosity(double V);

/// Upper limit of the distance in cells at which R differs from its values far from the membrane.
inline constexpr double kLayerReach = 2;

/// The factors of the three terms.
struct LayerCorrections {
  double slip;     ///< s / dx
  double tension;  ///< t / dx
  double kink;     ///< C / psi; at least 0
};
LayerCorrections layer_corrections(double V);

}  // namespace capstan
