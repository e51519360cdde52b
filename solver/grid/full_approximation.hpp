#pragma once
// The full approximation storage multigrid cycle (paper eqs. 22-25), for any hierarchy of levels.
//
// A level holds an approximation f of the solution of its equation r(f) = 0 and can
//   relax()                  improve f by one smoothing sweep
//   restrict_to(coarse)      give the coarse level its start I f and its equation
//                              r_H(f_H) = D_H,  D_H = r_H(I f) - I' r_h(f)
//   correct_from(coarse)     add the interpolated coarse change f_H - I f to f
#include <concepts>
#include <cstddef>
#include <span>

namespace capstan {

template <class L>
concept FasLevel = requires(L fine, L coarse) {
  fine.relax();
  fine.restrict_to(coarse);
  fine.correct_from(coarse);
};

struct CycleShape {
  int pre = 1;     ///< sweeps before the visit of the coarser level
  int post = 1;    ///< sweeps after it
  int visits = 2;  ///< of the coarser level: 1 is a V-cycle, 2 a W-cycle
  int once =
      1;  ///< so many levels, from the coarsest on, are visited once a visit of the finer one all the same
  int coarsest = 10;  ///< sweeps on the coarsest level
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
  const int visits = int(levels.size()) - 1 <= shape.once ? 1 : shape.visits;
  for (int visit = 0; visit < visits; ++visit) fas_cycle(levels.subspan(1), shape);
  fine.correct_from(coarse);
  for (int sweep = 0; sweep < shape.post; ++sweep) fine.relax();
}

}  // namespace capstan
