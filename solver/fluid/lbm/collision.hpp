#pragma once
// Multiple-relaxation-time (MRT) collision (d'Humieres et al. 2002) with a body force (Lallemand et al.
// 2007), one row of cells at a time.
//
// Populations are stored as deviations from those of the fluid at rest with density 1; rho below is the
// deviation of the density. The equilibrium is the incompressible one: products of momenta are divided by the
// mean density 1.
#include <cstddef>

#include "solver/fluid/lbm/d3q19.hpp"

namespace capstan {

/// Relaxation rates of the moments that do not determine the shear viscosity, and the free constants of the
/// equilibrium. A steady flow does not depend on them, except for errors of the discretisation.
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

/// The paper's rates: 1.8 for all moments but the stress; constants of d'Humieres et al. for stability. The
/// paper does not state the bulk viscosity (eq. 16); s_1 = 1.19 of d'Humieres et al. is used.
inline constexpr MrtRates kPaperRates = {1.19, 1.8, 1.8, 1.8, 1.8, 0, -475.0 / 63, 0};

/// Relaxation rate of the stress moments for a kinematic viscosity in lattice units (eq. 15).
inline double stress_rate(double nu_lu) { return 1 / (3 * nu_lu + 0.5); }

/// One row of cells to collide: pointers to arrays of `count` cells each.
///
/// The arrays f_star may be the same memory as the arrays f, in any order: all populations of a cell are read
/// before the first one is written.
template <class Real>
struct CollisionRow {
  const Real* f[d3q19::kQ];  ///< populations before
  Real* f_star[d3q19::kQ];   ///< populations after
  const Real* s_nu;          ///< relaxation rate of the stress in each cell
  const Real* force[3];      ///< force on each cell, lattice units
  std::size_t count;
};

/// f* = f - M^-1 S (M f - m_eq) with force (paper eqs. 13, 18, 19).
/// \param inertia  factor of the products of momenta in m_eq: 1, or 0 for Stokes flow. On a coarse multigrid
///                 level the lattice velocities and the lattice viscosity are the same, but the spacing is
///                 2^level times larger. The factor 2^level keeps the Reynolds number.
void collide(const CollisionRow<double>& row, const MrtRates& rates, double inertia);
void collide(const CollisionRow<float>& row, const MrtRates& rates, double inertia);

}  // namespace capstan
