#pragma once
// One sweep over a row of cells in which the viscosity varies: the lattice Boltzmann equation, solved exactly
// on every link between two cells.
//
// Let R be the viscosity ratio of a cell. The collision has two relaxation rates (Ginzburg, Verhaeghe and
// d'Humieres 2008): s for the parts of the populations that are equal in opposite directions, which sets the
// viscosity, 1/s - 1/2 = R/2, and s' for the parts that are opposite. In steady flow s' changes the errors of
// the lattice only, and with a fixed product (1/s - 1/2)(1/s' - 1/2) these do not depend on R. With 1/4 for
// this product - its value in the ambient fluid, where both rates are 1 - the collision is
//
//   f*_i = f^eq_i + c (f_-i - f^eq_-i),   c = 1 - s = (R - 1)/(R + 1),   f^eq_i = w_i (R rho + 3 e_i.g).
//
// (Here rho is the density in units of R: a viscous fluid has pressures that are R times as large.) A
// population that arrives in the steady state, f_i(x) = f*_i(x'), x' = x - e_i, therefore depends on the one
// that travels the same link in the opposite direction, f_-i(x') = f*_-i(x), and on nothing else. The two
// equations give, with rho', g', R' at x',
//
//   f_i - f^eq_i = (R + 1)/2 w_i k_i [R' (rho' + 3 e_i.(g' - g)) - R rho],   k_i = 2/(R + R'). (a)
//
// The sum of (a) over the links of a cell is 0 for the mass. For the momentum it is -(R + 1)/(2 R) F: the
// collision reverses this sum and multiplies it by c, which adds the momentum F. So the flow is determined by
// density and momentum alone,
//
//   sum_i w_i k_i [R' (rho' + 3 e_i.(g' - g)) - R rho] = 0,
//   R sum_i w_i k_i e_i [R' (rho' + 3 e_i.(g' - g)) - R rho] + F = 0,   u = g - F/(2 R), (b)
//
// with F in units in which the viscosity is R/6. With (R' p + R p')/(R + R') as the pressure of a link, p = R
// rho/3, both cells of a link exert opposite forces on each other. The viscous force is that of a dashpot
// along the link, whose viscosity is the harmonic mean 2 R R'/(R + R'). Pressure gradient and divergence are
// adjoint, and across layers in which R varies along an axis the shear stress is exactly continuous. In
// uniform fluid this is the sweep of moment_sweep.hpp, with F/R for F.
//
// The undisturbed flow (y, 0, 0) adds -e_x e_y dx to e_i.(g' - g). The time derivative and convection are
// forces. Relaxation multiplies what is left of (b) by gamma and divides it by the factor of the cell's own
// momentum in it, or 3/2 of that of its density: uniform fluid is relaxed as in moment_sweep.hpp. Where
// convection by the undisturbed flow is stronger than the viscous force, as in thin fluid, 2 |shear| + |lift|
// is the divisor instead.
#include "solver/grid/index_box.hpp"

namespace capstan {

/// A row of cells. The pointers are to its first cell; the fields of moments (moment_sweep.hpp) have equal
/// strides. Ghosts are read, and those at the ends of the row are copied to `out`.
template <class T>
struct LinkRow {
  const T* m;       ///< moments
  const T* defect;  ///< D, added to (b): the force, or the defect correction of a finer grid
  T* out;           ///< moments, or what is left of (b)
  Strides strides;
  const T* ratio;  ///< R
  Strides ratio_strides;
  int count;      ///< cells
  T dx;           ///< spacing / a
  T rate;         ///< of unsteady flow: Re nu dx^2 alpha_0
  T shear, lift;  ///< of convection: Re nu dx y / 2, Re nu dx^2
};

/// out <- the moments after relaxation by gamma.
void relax_links(const LinkRow<float>& row, float gamma);
void relax_links(const LinkRow<double>& row, double gamma);

/// out <- the left-hand sides of (b).
void put_residual_of_links(const LinkRow<float>& row);
void put_residual_of_links(const LinkRow<double>& row);

}  // namespace capstan
