#pragma once
// Lattice units of a case.
#include "solver/case/case.hpp"
#include "solver/grid/lattice_units.hpp"

namespace capstan {

/// Viscosity of the ambient fluid in the transient lattice, lattice units: the paper's. At dx = 0.1 a and Re
/// = 0.05 the time step is then k dt = 2e-5.
inline constexpr double kTransientViscosity = 0.04;

inline LatticeUnits transient_units(const Case& c) {
  return lattice_units(c.Re, kTransientViscosity, c.fidelity.dx);
}

}  // namespace capstan
