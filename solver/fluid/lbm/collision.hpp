#pragma once
// Multiple-relaxation-time collision (d'Humieres et al. 2002) with the force of Lallemand et al. 2007, one
// row of cells at a time.
//
// Populations are kept as deviations from the fluid at rest with density 1, so rho below is the deviation of
// the density. The equilibrium is the incompressible one: products of momentum are divided by the mean
// density 1.
#include <cstddef>

#include "solver/fluid/lbm/d3q19.hpp"

namespace capstan {

/// Relaxation rates of the moments that do not carry the shear viscosity, and the free constants of the
/// equilibrium. In a steady flow they are numerical choices.
struct MrtRates {
  double e;      ///< s_1: bulk viscosity
  double eps;    ///< s_2
  double q;      ///< s_4 = s_6 = s_8: energy flux
  double pi;     ///< s_10 = s_12
  double m;      ///< s_16 = s_17 = s_18
  double w_eps;  ///< eps_eq = w_eps rho + w_eps_j j^2
  double w_eps_j;
  double w_xx;  ///< pi_xx_eq = w_xx p_xx_eq
};

/// The paper's: s = 1.8 for all but the stress, constants of d'Humieres et al. for stability. The bulk
/// viscosity (eq. 16) is not stated in the paper; d'Humieres' s_1 = 1.19 is used.
inline constexpr MrtRates kPaperRates = {1.19, 1.8, 1.8, 1.8, 1.8, 0, -475.0 / 63, 0};

/// Rate of the stress moments for a kinematic viscosity in lattice units (eq. 15).
inline double stress_rate(double nu_lu) { return 1 / (3 * nu_lu + 0.5); }

/// Population q of the flow u_x = shear * y with its viscous stress (Chapman-Enskog, rho c_s^2 = 1/3).
inline double couette_population(int q, double shear, double y, double s_nu) {
  const double pxy = -shear / (3 * s_nu);
  return 3 * d3q19::weight(q) * d3q19::e[q].x * shear * y + d3q19::moment_row(d3q19::m_pxy, q) / 4.0 * pxy;
}

/// One row of cells to collide. Arrays of `count` cells each.
///
/// f* may lie where f lies, with any permutation of the arrays: all populations of a cell are read before one
/// is written.
template <class Real>
struct CollisionRow {
  const Real* f[d3q19::kQ];  ///< populations before
  Real* f_star[d3q19::kQ];   ///< populations after
  const Real* s_nu;          ///< stress rate cell by cell
  const Real* force[3];      ///< force a cell, lattice units
  std::size_t count;
};

/// f* = f - M^-1 S (M f - m_eq) with force (paper eqs. 13, 18, 19).
/// \param inertia  factor of the products of momentum in m_eq: 1, or 0 for Stokes flow; a coarse multigrid
/// level
///                 that keeps the numbers of the velocity has its Reynolds number restored by 2^level
void collide(const CollisionRow<double>& row, const MrtRates& rates, double inertia);
void collide(const CollisionRow<float>& row, const MrtRates& rates, double inertia);

}  // namespace capstan
