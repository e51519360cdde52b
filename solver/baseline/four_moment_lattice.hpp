#pragma once
// The standard method with its best parameters: the lattice Boltzmann equation in time with all relaxation
// rates 1 and the lattice viscosity 1/6, for V = 1 and without inertia.
//
// After a collision with all rates 1 (paper eq. 13 with m_eq linear) the populations depend only on the
// density rho and the momentum g = j + F:
//   f*_q = w_q phi_q,   phi_q = rho + 3 e_q.g.
// Streaming then gives the moments at the next time step from those of the neighbours:
//   rho(x) = sum_q w_q phi_q(x - e_q),   j(x) = sum_q w_q e_q phi_q(x - e_q).
// So a cell has 4 numbers instead of 19; the results are equal up to rounding errors. A step reads one array
// and writes another. Updating a cell moves 12 numbers: 4 are read, 4 are written, and before they are
// written the 4 old values are loaded into the cache (write allocation). No force is added, since a force
// acts only on the few cells around the capsule.
#include <cstddef>
#include <utility>
#include <vector>

#include "solver/grid/huge_pages.hpp"
#include "solver/grid/index_box.hpp"

namespace capstan {

/// The moments rho, g_x, g_y, g_z of a box of cells. The four rows of a row of cells follow each other in
/// memory, each with a periodic ghost at both ends.
template <class Real>
class MomentField {
 public:
  explicit MomentField(const IndexBox& box);

  /// The cell x = 0.
  /// \param moment  0: rho, 1 to 3: g
  Real* row(int moment, int y, int z) { return numbers_.data() + offset(moment, y, z); }
  const Real* row(int moment, int y, int z) const { return numbers_.data() + offset(moment, y, z); }
  /// Distance in memory from a moment to the next one of the same cell.
  std::ptrdiff_t stride() const { return stride_; }
  /// Sets the ghosts of a row.
  void close_row(int y, int z);

 private:
  std::size_t offset(int moment, int y, int z) const {
    return kNumbersPerLine<Real> + ((std::size_t(z) * ny_ + y) * 4 + moment) * stride_;
  }

  int nx_, ny_;
  std::ptrdiff_t stride_;
  std::vector<Real, HugePageAllocator<Real>> numbers_;
};

/// \tparam Real  float or double
template <class Real>
class FourMomentLattice {
 public:
  /// \param box         the cells of the domain, numbered from 0
  /// \param wall_speed  of the upper wall along x; the lower wall moves the other way
  FourMomentLattice(const IndexBox& box, double wall_speed)
      : box_(box), wall_speed_(Real(wall_speed)), now_(box), next_(box) {}

  /// One time step.
  void step();
  MomentField<Real>& moments() { return now_; }

 private:
  void step_inner_row(int y, int z);
  void step_row_at_wall(int y, int z);
  void add_arriving(int q, int p, const Real* m, Real more, int y, int z);

  IndexBox box_;
  Real wall_speed_;
  MomentField<Real> now_, next_;
};

extern template class MomentField<float>;
extern template class MomentField<double>;
extern template class FourMomentLattice<float>;
extern template class FourMomentLattice<double>;

}  // namespace capstan
