#pragma once
// The errors of first order in dx that the immersed boundary method makes at a membrane, and the terms that
// cancel them.
//
// Near the membrane everything varies along its normal n only, on the scale of a cell. Units: dx = 1 in this
// derivation, mu_a = 1. Let z be the distance along n, f the tangential force per area of the membrane on
// the fluid, tau the mean shear stress, p(z) the kernel after sharpening (sharpening.hpp) and P its integral,
// q(z) and Q those of the smoothed jump of the viscosity (eq. 41). The stress relaxes with the harmonic mean
// of the viscosity (stress_tensor.hpp), so that with
//   beta = (V - 1)/(V + 1),   r = (1 + 1/V)/2
//   1/mu(z) = r (1 + 2 beta (Q - 1/2)),   u'(z) = (tau - f (P - 1/2)) / mu(z).
// A sharp membrane has the same with P and Q replaced by the Heaviside function. The two velocities agree far
// from the membrane on both sides only if the integral of the difference of u' is 0. It is not: the fluid on
// one side slips by
//   -f r beta E_m along n,   E_m = 2 int [1/4 - (P - 1/2)(Q - 1/2)] dz = E|X_p - X_q|,
// the mean distance of two random variables of the densities p and q.
//
// Slip: force dipoles cancel it. Instead of the force F of a vertex, F - div [s (F_t n + n F_t)] is spread,
// which adds s f p(z) to the stress and s f r to the integral: s = -beta E_m dx.
// Reading has the transposed error: int p u dz differs from u(0) by tau r beta E_m, since u has a kink. So
//   s (I - n n) (grad u + grad u^T) n
// is added to the velocity of a vertex, the undisturbed flow included. Both terms together are adjoint and
// symmetric; dipoles of this form exert neither force nor torque; rigid motion has no such gradient.
//
// Kink: what remains is proportional to f, since the kernel rounds the kink of the velocity off:
//   u_read = u - C f dx / mu_a,   at V = 1 C = E|X_p - X_p'|/2.
// C f dx is added as
//   C/psi dx^2 (I - n n) I[S F_t] / mu_a,   psi = int p_0^2 dz,
// with the kernel p_0 that is not sharpened, spreading S and interpolating I: then it has the smoothness of
// the velocity, and needs no area of a vertex. The sum over F_t . I[S F_t] is the integral of the square of
// S F_t: the power is never negative if C is not.
//
// On the lattice. The cells lie in planes across n at distances h: 1, 1/sqrt(2) and 1/sqrt(3) along the axes
// of the grid, the diagonals of its faces and of its cells. For these normals moment_sweep.hpp and
// stress_tensor.hpp reduce to
//   tau(j + 1/2) - tau(j - 1/2) = -F_j,
//   g_(j+1) - g_j = 6 h^2 tau(j + 1/2) [1 - (a_j + a_(j+1))/2] - 3/2 h^2 (a_j F_j - a_(j+1) F_(j+1)),
//   u_j = g_j - F_j/2,   a = 1 - 1/R = (1 - 1/V)(1 - Q),   F = f (p - s p')/6 in the middle of the plane.
// E_m and C are those of these sums, in the mean over the position of the membrane between the planes and, by
// Lebedev's rule with 26 points, over the direction of n.
//
// The reduction is exact for the axes and the diagonals of faces. Across the diagonals of cells the lattice
// also has links to the second next planes, which it leaves out: with them C is 0.081 there instead of 0.153
// at V = 1, and 0.127 instead of 0.145 in the mean. Measured at dx = 0.2: with 0.127 the error of Q of a
// sphere at V = 1 is 0.002 instead of 0.003, that of a red cell 0.008 instead of 0.003.
//
// Stress along the membrane. Here the strain rate is continuous, and the arithmetic mean of the viscosity
// counts (stress_tensor.hpp). But the lattice passes stress on to the next cells, so that the integral of the
// stress across the layer is smaller than with a sharp jump, as if the inner fluid ended a little inside of
// the membrane: at V = 4 by 0.02 cells under a strain that changes areas, by 0.09 cells under shear (exact
// solution near a flat membrane: studies/flat_membrane). The mean over the three strains along the membrane,
// the directions of n and the positions of the membrane, for V from 2 to 12, is
//   0.15 (V - 1)/(V + 2.85) cells.
// The jump of the arithmetic mean is moved outwards by this distance.
//
// What is still of first order in that solution, at V = 4 and 10:
//   C would have to be negative, -0.02 and -0.08; s is 7 to 8 % too small in magnitude.
//   A strain along the membrane that changes areas makes the fluid slip by 0.08 and 0.33 times its rate (root
//   mean square over the directions of n; nothing along the axes and the diagonals of faces and cells).
//   Without (b) of stress_tensor.hpp the slip has the opposite sign, so that a little less than half of (b)
//   would remove it, but the inner fluid needs all of it.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// Half width in cells over which the jump of the viscosity is smoothed. Measured at dx = 0.2 in eleven
/// scenes of V from 3 to 12, together with the shift below (studies/cross_validation): the error of Q is 0.3
/// to 1.1 times that with a half width of 1 and no shift, 0.6 times in the median. At dx = 0.1 it is larger
/// than with a half width of 1 from V = 7 on.
inline constexpr double kViscosityHalfWidth = 0.5;

/// Upper limit of shift_of_stress().
inline constexpr double kMaxShift = 0.15;

/// How far outside of the membrane the jump of the arithmetic mean lies, in cells. Fitted to the solution
/// above for V from 2 to 12. Negative for V < 1, where this is half of the distance in that solution.
inline double shift_of_stress(double V) { return kMaxShift * (V - 1) / (V + 2.85); }

/// The factors of the two terms.
struct LayerCorrections {
  double slip;  ///< s / dx
  double kink;  ///< C / psi; at least 0
};
LayerCorrections layer_corrections(double V);

/// C of a membrane along an axis of the grid (0), a diagonal of its faces (1) or of its cells (2) at V = 1.
double kink_along(int direction);

}  // namespace capstan
