#pragma once
// Multigrid with full approximation storage (paper eqs. 22-25), for any hierarchy of levels. Each level has
// twice the spacing of the next finer one.
//
// The unknowns f of each level obey an equation
//   A(f) = D.
// On the finest level D is given (a force, or zero); on a coarser level it is the defect correction, set by
// the next finer level. A lattice Boltzmann level has A(f) = f - S(f), where S is one collision and streaming
// step. The residual is the right-hand side minus the left-hand side,
//   r(f) = D - A(f),   for a lattice   r(f) = S(f) + D - f
// (the paper's eq. 21 has the opposite sign). From a fine level h to the next coarser one H, with the
// restrictions I of unknowns and I' of residuals, and the interpolation P:
//   start              f_H = I f_h
//   defect correction  D_H = A_H(I f_h) + I' r_h(f_h)        (eq. 24)
//   correction         f_h <- f_h + P (f_H - I f_h)
#include <concepts>
#include <cstddef>
#include <span>

namespace capstan {

template <class L>
concept FasLevel = requires(L fine, L coarse) {
  fine.relax();               // improves f by one smoothing sweep
  fine.restrict_to(coarse);   // writes the start f_H and the defect correction D_H of the coarse level
  fine.correct_from(coarse);  // adds the interpolated change of the coarse level to f
};

struct CycleShape {
  int pre = 1;            ///< sweeps before the visit of the coarser level
  int post = 1;           ///< sweeps after it
  int visits = 2;         ///< visits of the coarser level: 1 is a V-cycle, 2 a W-cycle
  int single_visits = 1;  ///< number of levels, counted from the coarsest, that are visited once only
  int coarsest = 10;      ///< sweeps on the coarsest level
};

/// One cycle on levels[0] (finest) ... levels.back() (coarsest).
template <FasLevel L>
void fas_cycle(std::span<L> levels, const CycleShape& shape) {
  L& fine = levels.front();
  if (levels.size() == 1) {
    for (int sweep = 0; sweep < shape.coarsest; ++sweep) fine.relax();
    return;
  }
  L& coarse = levels[1];
  for (int sweep = 0; sweep < shape.pre; ++sweep) fine.relax();
  fine.restrict_to(coarse);
  const int visits = int(levels.size()) - 1 <= shape.single_visits ? 1 : shape.visits;
  for (int visit = 0; visit < visits; ++visit) fas_cycle(levels.subspan(1), shape);
  fine.correct_from(coarse);
  for (int sweep = 0; sweep < shape.post; ++sweep) fine.relax();
}

}  // namespace capstan
