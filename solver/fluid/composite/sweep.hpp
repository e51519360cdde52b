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
// viscosity (1/s - 1/2)/3 as ever. Products of momentum are not in (a): see convection.hpp.
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

/// A row of cells outside of the capsule; pointers to rho of its first cell.
template <class T>
struct FluidRow {
  const T* m;       ///< before; neighbours by `strides`
  const T* defect;  ///< D, same strides
  T* out;           ///< same strides
  Strides strides;
  int count;
  T keep, blend;
};
void sweep_fluid(const FluidRow<float>& row);
void sweep_fluid(const FluidRow<double>& row);

/// A row of cells with stresses: all moments.
template <class T>
struct StressRow {
  FluidRow<T> fluid;
  const T* q;         ///< Q of (a), at the first cell and all around it
  const T* p;         ///< P before
  const T* p_defect;  ///< of P
  T* p_out;
  Strides stress_strides;
  T p_keep, p_blend;
};
void sweep_stress(const StressRow<float>& row);
void sweep_stress(const StressRow<double>& row);

}  // namespace capstan
