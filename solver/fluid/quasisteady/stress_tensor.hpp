#pragma once
// The stress that a cell passes on to its neighbours (moment_sweep.hpp), near a membrane too.
//
// Away from the membrane it is Q = c P. The smoothed jump of the viscosity is a layer: along its normal n
// the shear stress is continuous, and the strain rates of the layer add up, so its harmonic mean counts; in
// all other directions the strain rate is continuous, the stresses add up, and the arithmetic mean counts.
// With t = (I - n n) P n,
//   Q = c P + (c_H - c) (n t + t n),   c = 1 - 2/(1 + R), (a)
// for the arithmetic and the harmonic mean of the viscosity ratio R. (The jump of the first lies at a small
// distance from the membrane: membrane_layer.hpp.) For the shear stress in one direction this is exact on the
// lattice: with the mean stress tau of a cell, P + Q = -2 tau, so that g(z+1) - g(z) is 6 tau times the mean
// of 1/R in the two cells.
//
// The other part of P, c P' = c (P - n t - t n), has an error that grows with R. P** sums populations of the
// neighbours: P = P_g + A[Q], where P_g comes from their momenta and A is a mean over a distance of one cell.
// Where R is large this spreads the stress over sqrt((R - 1)/8) cells, like the mean free path in a gas, and
// the stress of the inner fluid is too small within that distance of the membrane. So
//   D = L[c P' - A[c P']] (b)
// is added to P**, with L twice the mean of weights 1/4 1/2 1/4 along each axis: P' is then spread to fourth
// order only. Without L the iteration would diverge at the shortest waves. It is added once a cycle, from
// the stress at its start, and converges by a factor of 0.2 a cycle.
#include "solver/fluid/quasisteady/moment_sweep.hpp"

namespace capstan {

/// Components of the field of viscosities and normals.
enum InterfaceComponent { kArithmetic, kHarmonic, kNormalX, kNormalY, kNormalZ, kInterfaces };

/// A row of cells. The pointers are to the first component of its first cell.
template <class T>
struct TensorRow {
  const T* p;  ///< P, minus the stress of the undisturbed flow
  T* q;        ///< result
  std::ptrdiff_t stress_stride;
  const T* interface;  ///< c, c_H - c, n; n is 0 far from the membrane
  std::ptrdiff_t interface_stride;
  int count;      ///< cells
  T undisturbed;  ///< P_xy of the undisturbed flow
};

/// Q of (a).
void put_passed_stress(const TensorRow<float>& row, bool is_near_membrane);
void put_passed_stress(const TensorRow<double>& row, bool is_near_membrane);

/// c P' of (b).
void put_stress_without_shear(const TensorRow<float>& row, bool is_near_membrane);
void put_stress_without_shear(const TensorRow<double>& row, bool is_near_membrane);

}  // namespace capstan
