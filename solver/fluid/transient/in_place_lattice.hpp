#pragma once
// The lattice Boltzmann equation in time on a box of cells between two moving walls in y, periodic in x and
// z: the same equation as Level::step, in one pass over one array.
//
// Streaming in place (Bailey et al. 2009, the "AA" pattern). A population q of a cell x has one of two
// places:
//   streamed   in the cell itself, array q
//   collided   in the cell it comes from, x - e_q, in the array of the opposite direction
// A step reads a cell's populations from one kind of place, collides them, and writes each where its opposite
// was read; that is the other kind of place of the next step. So every number is read and written once a
// step, by one cell alone: 2 x 19 numbers of memory traffic an update, none for arrays that are only written
// to, half the memory of two arrays; and cells may be taken in any order by any number of threads, with the
// same result to the last bit.
//
// Half-way bounce-back needs no other place: what comes from the wall stands where the cell put what went
// there.
#include <array>
#include <cstddef>
#include <vector>

#include "solver/fluid/lbm/collision.hpp"
#include "solver/fluid/lbm/population_field.hpp"
#include "solver/grid/cell_box.hpp"
#include "solver/grid/huge_pages.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

struct LatticeSettings {
  MrtRates rates;
  double nu_lu;        ///< lattice viscosity of the ambient fluid
  double wall_speed;   ///< of the upper wall along x, lattice units; the lower wall moves the other way
  double inertia = 1;  ///< see collide()
};

/// Real: float or double, of the stored populations and of the collision.
template <class Real>
class InPlaceLattice {
 public:
  InPlaceLattice(Extent extent, const LatticeSettings& settings);

  /// One time step.
  void step();

  /// Couette flow u_x proportional to y, with its viscous stress.
  void set_couette();
  /// Force on the fluid and viscosity, lattice units, in the cells of a box that stays owned by the caller.
  /// Null: no force, the ambient viscosity.
  void set_force(const VectorBox* force) { force_ = force; }
  void set_viscosity(const ScalarBox* nu_lu) { viscosity_ = nu_lu; }

  Extent extent() const { return extent_; }
  /// The populations of a row of cells that a step would collide: 19 arrays of nx numbers.
  void read_row(int y, int z, std::vector<Real>& populations) const;
  /// Velocities in the cells of the box (lattice units): j + F/2 (eq. 18).
  void velocity(VectorBox& box) const;

  void save(StateArchive& archive) const;
  void load(const StateArchive& archive);

 private:
  enum class Places { streamed, collided };
  struct RowCoefficients;
  using Row = std::array<Real*, d3q19::kQ>;

  Real* array(int q, int y, int z);
  bool comes_from_wall(int q, int y) const;
  bool wraps(int q, int y) const { return d3q19::e[q].x != 0 && !comes_from_wall(q, y); }
  Real* place(int q, int y, int z);
  const Real* place(int q, int y, int z) const { return const_cast<InPlaceLattice*>(this)->place(q, y, z); }
  void step_row(int y, int z, RowCoefficients& coefficients);
  void push_walls(int y, const Row& row) const;
  void take_from_ghosts(int y, const Row& row) const;
  void put_into_ghosts(int y, const Row& row) const;

  LatticeSettings settings_;
  Extent extent_;
  std::size_t row_stride_, array_stride_;
  std::vector<Real, HugePageAllocator<Real>> populations_;
  Places places_ = Places::streamed;
  const VectorBox* force_ = nullptr;
  const ScalarBox* viscosity_ = nullptr;
};

extern template class InPlaceLattice<float>;
extern template class InPlaceLattice<double>;

}  // namespace capstan
