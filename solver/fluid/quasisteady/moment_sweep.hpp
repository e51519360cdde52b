#pragma once
// The lattice Boltzmann equation in moments: one sweep (collision, streaming, relaxation) over a row of
// cells.
//
// The scheme is the paper's MRT collision (eqs. 13-15) on D3Q19. In steady flow all relaxation rates except
// that of the stress are free, and so is the lattice viscosity of the ambient fluid. With all free rates
// equal to 1, the population that leaves a cell along e_i is determined by the cell's density rho (deviation
// from 1), its momentum g (force F included) and its traceless stress P:
//
//   f*_i = w_i phi_i,   phi_i = rho + 3 e_i.g + 9/2 e_i e_i : Q,   Q = (1 - s) P,   s = 1/(3 nu + 1/2) (a)
// (stress_tensor.hpp has Q near a membrane).
//
// After streaming the moments of a cell at x are
//
//   rho** = sum_i w_i phi_i(x - e_i),   g** = sum_i w_i e_i phi_i(x - e_i) + F,
//   P**   = traceless part of sum_i w_i e_i e_i phi_i(x - e_i). (b)
//
// The ambient fluid has nu = 1/6, hence s = 1: its stress has no effect. So a cell has 4 unknowns (rho, g)
// instead of 19, and 9 in and near the capsule if its viscosity differs. The velocity is u = g - F/2 and the
// viscosity (1/s - 1/2)/3, as for populations. The fourth-order moments pi are free in steady flow; in (a)
// they take their Hermite values, which differ from those of the MRT basis.
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
/// Components of a field of stresses. P_zz = -P_xx - P_yy.
enum StressComponent { kXX, kYY, kXY, kXZ, kYZ, kStresses };

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

/// Relaxation factors per unit of -c, for density, momentum and stresses. They are added to those of the row,
/// so that a thin fluid (c < 0) is relaxed with factors of its own. A fixed point of the sweep does not
/// depend on them.
struct ThinFluidFactors {
  double rho = 0, g = 0, p = 0;
};

/// A row of cells with stresses.
template <class T>
struct StressRow {
  FluidRow<T> fluid;
  const T* factor;    ///< c
  const T* q;         ///< Q, with ghosts, the stress of the undisturbed flow included
  const T* p;         ///< P, minus the stress of the undisturbed flow
  const T* p_defect;  ///< D of the stresses
  T* p_out;
  Strides stress_strides;
  T p_keep, p_blend;
  T thin_rho = 0, thin_p = 0;           ///< ThinFluidFactors of density and stresses
  T thin_g_keep = 0, thin_g_blend = 0;  ///< that of the momentum, and the same / (1 + rate)
};
void sweep_stress(const StressRow<float>& row);
void sweep_stress(const StressRow<double>& row);

}  // namespace capstan
