#pragma once
// Conversion from the dimensionless numbers of every interface (a = k = mu_a = 1) to lattice units (spacing,
// time step and density are 1).

namespace capstan {

struct LatticeUnits {
  double dx;           ///< lattice spacing / a
  double nu_lu;        ///< viscosity of the ambient fluid in lattice units
  double velocity_lu;  ///< lattice velocity of the dimensionless velocity 1: Re nu_lu dx
  double force_lu;     ///< force in lattice units on a cell that takes the whole dimensionless force 1
  double kdt;          ///< k dt of one lattice time step: Re nu_lu dx^2
};

/// Re = k a^2 / nu fixes the lattice shear rate k_lu = Re nu_lu dx^2. A velocity u (units a k) is then u k_lu
/// / dx. A force density p mu_a k / a balances mu_a k / a times the Laplacian of u, so F_lu = nu_lu
/// velocity_lu dx^2 p; a force f spread over one cell is the density f / dx^3.
inline LatticeUnits lattice_units(double Re, double nu_lu, double dx) {
  const double velocity_lu = Re * nu_lu * dx;
  return {dx, nu_lu, velocity_lu, nu_lu * velocity_lu / dx, Re * nu_lu * dx * dx};
}

}  // namespace capstan
