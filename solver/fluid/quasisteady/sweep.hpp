#pragma once
// The lattice Boltzmann equation in moments: one sweep over a row of cells.
//
// Collide and stream with the paper's MRT scheme (eqs. 13-15), D3Q19. In steady flow the rates of all moments
// but the stress are free, and so is the lattice viscosity of the ambient fluid. With all free rates 1, what
// a cell sends along e_i depends on its density rho (deviation from 1), its momentum g after the force F, and
// its traceless stress P:
//
//   f*_i = w_i phi_i,   phi_i = rho + 3 e_i.g + 9/2 e_i e_i : Q,   Q = (1 - s) P,   s = 1/(3 nu + 1/2) (a)
//
// and what arrives has the moments
//
//   rho** = sum w_i phi_i(x - e_i),   g** = sum w_i e_i phi_i(x - e_i) + F,   P** = traceless part of
//   sum w_i e_i e_i phi_i(x - e_i). (b)
//
// With nu = 1/6 outside (s = 1) the stress matters only where the viscosity is another: 4 numbers a cell
// instead of 19, and 9 in and near the capsule. (MRT's basis leaves to each stress a choice of its companion
// pi of the fourth order, an equally free moment; (a) is Hermite's.) The fluid's velocity is u = g - F/2, its
// viscosity (1/s - 1/2)/3 as ever. Of convection, which is quadratic in the momentum, (a) has nothing; what
// the undisturbed flow carries, and what carries the undisturbed flow, is subtracted from g**,
//
//   Re nu dx^2 (y dg/dx + g_y e_x)   (lengths in units of a, d/dx by central differences), (c)
//
// and the rest is part of D: see convection.hpp.
//
// A sweep relaxes, m <- keep m + blend (m** + D), with the defect D of a multigrid level (eq. 24; on the
// finest level the force F); with keep = -1, blend = 1 the result is the residual m** + D - m.
#include <cstddef>

namespace capstan {

/// nu of the ambient fluid, lattice units.
inline constexpr double kAmbientViscosity = 1. / 6;

/// Components of a field of moments, and of a field of stresses (P_zz = -P_xx - P_yy).
enum MomentComponent { kRho, kGx, kGy, kGz, kMoments };
enum StressComponent { kXX, kYY, kXY, kXZ, kYZ, kStresses };

/// Distances in memory between neighbours of a field: see RowField.
struct Strides {
  std::ptrdiff_t component, y, z;
};

/// A row of cells outside of the capsule; pointers to rho of its first cell, all of the same strides. Rows
/// begin and are padded as in RowField.
template <class T>
struct FluidRow {
  const T* m;       ///< before, with ghosts, which are handed on
  const T* defect;  ///< D
  T* out;
  Strides strides;
  int count;
  T keep, blend;
  T shear = 0, lift = 0;  ///< of (c): Re nu dx y / 2, Re nu dx^2
};
void sweep_fluid(const FluidRow<float>& row);
void sweep_fluid(const FluidRow<double>& row);

/// A row of cells with stresses: all moments.
template <class T>
struct StressRow {
  FluidRow<T> fluid;
  const T* contrast;  ///< 1 - s, with ghosts
  Strides contrast_strides;
  const T* p;         ///< P before, with ghosts
  const T* p_defect;  ///< of P
  T* p_out;
  Strides stress_strides;
  T p_keep, p_blend;
  T undisturbed;  ///< P_xy of the undisturbed flow, which P is without
};
void sweep_stress(const StressRow<float>& row);
void sweep_stress(const StressRow<double>& row);

}  // namespace capstan
