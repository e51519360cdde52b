#pragma once
// Populations of Couette flow, momentum exchanged with a moving wall, and momentum of populations.
#include <algorithm>
#include <array>

#include "solver/fluid/lbm/d3q19.hpp"

namespace capstan {

/// Pointers to the 19 populations of a row of cells.
template <class Real>
using PopulationRow = std::array<Real*, d3q19::kQ>;

/// Population q of the flow u_x = shear * y with its viscous stress (Chapman-Enskog expansion, rho c_s^2 =
/// 1/3).
/// \param s_nu  relaxation rate of the stress
inline double couette_population(int q, double shear, double y, double s_nu) {
  const double pxy = -shear / (3 * s_nu);
  return 3 * d3q19::weight(q) * d3q19::e[q].x * shear * y + d3q19::moment_row(d3q19::m_pxy, q) / 4.0 * pxy;
}

/// Momentum 6 w_q e_q . u_wall that a moving wall adds to the population q that leaves it (half-way
/// bounce-back). The walls are normal to y and move along x.
/// \param wall_speed  of the upper wall, along x; the lower wall moves the other way
inline double momentum_from_wall(int q, double wall_speed) {
  const bool is_from_upper = d3q19::e[q].y < 0;
  return 6 * d3q19::weight(q) * d3q19::e[q].x * (is_from_upper ? wall_speed : -wall_speed);
}

/// Component c of the momentum j = sum_q e_q f_q of `count` cells, in double precision whatever the
/// populations are.
template <class Real>
void momentum_of_row(const PopulationRow<const Real>& f, int c, int count, double* j) {
  std::fill_n(j, count, 0.0);
  for (int q = 1; q < d3q19::kQ; ++q) {
    const double e_c = d3q19::component(q, c);
    for (int x = 0; e_c != 0 && x < count; ++x) j[x] += e_c * double(f[q][x]);
  }
}

}  // namespace capstan
