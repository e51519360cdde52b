#pragma once
// Between the dimensionless numbers of every interface (a = k = mu_a = 1) and lattice units (spacing, time
// step and density 1). The only other place that knows lattice units is solver/fluid/lattice.
#include "solver/case/case.hpp"

namespace capstan {

struct LatticeUnits {
  double dx;           ///< lattice spacing / a
  double nu_lu;        ///< viscosity of the ambient fluid in lattice units
  double velocity_lu;  ///< lattice velocity of a dimensionless velocity 1: Re nu_lu dx
  double force_lu;     ///< lattice force a cell of a dimensionless force 1 spread over one cell
  double kdt;          ///< k dt of one lattice time step: Re nu_lu dx^2
};

/// Re = k a^2 / nu fixes the lattice shear rate k_lu = Re nu_lu dx^2; a velocity u a k is then u k_lu / dx.
/// Force density p mu_a k / a balances mu_a k / a times the Laplacian of u, so F_lu = nu_lu velocity_lu dx^2
/// p, and a force f spread over one cell is the density f / dx^3.
inline LatticeUnits lattice_units(double Re, double nu_lu, double dx) {
  const double velocity_lu = Re * nu_lu * dx;
  return {dx, nu_lu, velocity_lu, nu_lu * velocity_lu / dx, Re * nu_lu * dx * dx};
}

/// The paper's viscosity of the transient lattice: at dx = 0.1 a and Re = 0.05 the time step is k dt = 2e-5.
inline constexpr double kTransientViscosity = 0.04;

inline LatticeUnits transient_units(const Case& c) {
  return lattice_units(c.Re, kTransientViscosity, c.fidelity.dx);
}

}  // namespace capstan
