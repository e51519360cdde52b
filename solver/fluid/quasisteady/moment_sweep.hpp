#pragma once
// The lattice Boltzmann equation in moments: one sweep (collision, streaming, relaxation) over a row of
// cells of the ambient fluid. link_sweep.hpp has that for rows in which the viscosity varies.
//
// The scheme is the paper's MRT collision (eqs. 13-15) on D3Q19. In steady flow all relaxation rates except
// that of the stress are free, and so is the lattice viscosity of the ambient fluid. With all free rates
// equal to 1 and the viscosity 1/6, that of the stress is 1, too, and the population that leaves a cell along
// e_i is determined by the cell's density rho (deviation from 1) and its momentum g (force F included):
//
//   f*_i = w_i phi_i,   phi_i = rho + 3 e_i.g. (a)
//
// After streaming the moments of a cell at x are
//
//   rho** = sum_i w_i phi_i(x - e_i),   g** = sum_i w_i e_i phi_i(x - e_i) + F. (b)
//
// So a cell has 4 unknowns (rho, g) instead of 19. The velocity is u = g - F/2.
//
// (a) has no convection, which is quadratic in the momentum. Convection of the deviation g by the undisturbed
// flow (y, 0, 0), and of the undisturbed flow by the deviation, is subtracted from g**:
//
//   Re nu dx^2 (y dg/dx + g_y e_x)   (lengths in units of a; d/dx by central differences). (c)
//
// The rest of convection is part of D: see convection.hpp.
//
// A sweep computes  keep m + blend (m** + D).  Relaxation by gamma has keep = 1 - gamma, blend = gamma; keep
// = -1, blend = 1 gives the residual m** + D - m. D is the force F on the finest grid and the defect
// correction (eq. 24) on coarser ones.
//
// In unsteady flow (time_derivative.hpp) the equation of the momentum is g = g** + D - rate g. Its relaxation
// has keep = 1 - gamma, blend = gamma/(1 + rate), its residual keep = -1 - rate, blend = 1.
#include "solver/grid/index_box.hpp"

namespace capstan {

/// Lattice viscosity of the ambient fluid.
inline constexpr double kAmbientViscosity = 1. / 6;

/// Components of a field of moments.
enum MomentComponent { kRho, kGx, kGy, kGz, kMoments };

/// A row of cells of the ambient viscosity. The pointers are to rho in its first cell; all fields (RowField)
/// have equal strides.
template <class T>
struct FluidRow {
  const T* m;       ///< moments; their ghosts are read, and copied to `out`
  const T* defect;  ///< D
  T* out;
  Strides strides;
  int count;          ///< cells
  T keep, blend;      ///< of the density
  T g_keep, g_blend;  ///< of the momentum
  T shear = 0;        ///< of (c): Re nu dx y / 2
  T lift = 0;         ///< of (c): Re nu dx^2
};
void sweep_fluid(const FluidRow<float>& row);
void sweep_fluid(const FluidRow<double>& row);

}  // namespace capstan
