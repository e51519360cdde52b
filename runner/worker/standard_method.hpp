#pragma once
// The standard lattice Boltzmann method that speed-ups are stated against, as the paper runs it.
#include "solver/baseline/kernel_speed.hpp"

namespace capstan {

/// The standard method on a uniform grid of 128^3 cells, dx = 0.1 a, with a measured rate of lattice updates.
/// The time of its membrane and of its viscosity field is left out, which favours it.
struct StandardMethod {
  KernelSpeed speed;
  double kdt;  ///< shear strain of a lattice step

  /// Time to the end of a run.
  double seconds(double kt) const;
};

/// Measures the method with 19 populations at the paper's lattice viscosity 0.04, Re = 0.05: k dt = 2e-5.
StandardMethod standard_method_of_paper();

/// Measures the method at its own best: four moments and tau = 1. With a larger relaxation time the lattice's
/// discretisation errors grow.
StandardMethod standard_method_at_its_best();

}  // namespace capstan
