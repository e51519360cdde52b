#pragma once
// The standard method at its own best: the lattice Boltzmann equation in time with all relaxation rates 1 and
// the lattice viscosity 1/6, V = 1, without inertia.
//
// Collision with all rates 1 forgets everything but the density rho and the momentum g = j + F (paper eq. 13
// with S = 1 but for the conserved moments, m_eq linear):
//   f*_q = w_q phi_q,   phi_q = rho + 3 e_q.g
// so that streaming gives the moments at the next time step from those of the neighbours:
//   rho(x) = sum_q w_q phi_q(x - e_q),   j(x) = sum_q w_q e_q phi_q(x - e_q)
// Four numbers a cell instead of 19; equal to the 19 populations to round-off. Two arrays, since neighbours
// are read: 4 numbers are read, 4 are fetched to be overwritten and 4 written, 12 an update. No force is
// added here: it touches the cells around the capsule alone.
#include <cstddef>
#include <utility>
#include <vector>

#include "solver/fluid/lbm/population_field.hpp"
#include "solver/grid/huge_pages.hpp"

namespace capstan {

/// Rows of cells, each with its rho and then its three g, and with a periodic ghost at both ends of them.
template <class Real>
class MomentField {
 public:
  explicit MomentField(Extent extent);

  /// The cell x = 0. \param moment 0: rho, 1 to 3: g
  Real* row(int moment, int y, int z) { return numbers_.data() + offset(moment, y, z); }
  const Real* row(int moment, int y, int z) const { return numbers_.data() + offset(moment, y, z); }
  /// From a row of rho to the same of g_x, and so on.
  std::ptrdiff_t stride() const { return stride_; }
  void close_row(int y, int z);

 private:
  std::size_t offset(int moment, int y, int z) const {
    return kCacheLine / sizeof(Real) + ((std::size_t(z) * ny_ + y) * 4 + moment) * stride_;
  }

  int nx_, ny_;
  std::ptrdiff_t stride_;
  std::vector<Real, HugePageAllocator<Real>> numbers_;
};

/// Real: float or double.
template <class Real>
class FourMomentLattice {
 public:
  /// \param wall_speed of the upper wall along x; the lower wall moves the other way
  FourMomentLattice(Extent extent, double wall_speed)
      : extent_(extent), wall_speed_(Real(wall_speed)), now_(extent), next_(extent) {}

  void step();
  MomentField<Real>& moments() { return now_; }

 private:
  void step_inner_row(int y, int z);
  void step_row_at_wall(int y, int z);
  void add_arriving(int q, int p, const Real* m, Real more, int y, int z);

  Extent extent_;
  Real wall_speed_;
  MomentField<Real> now_, next_;
};

extern template class MomentField<float>;
extern template class MomentField<double>;
extern template class FourMomentLattice<float>;
extern template class FourMomentLattice<double>;

}  // namespace capstan
