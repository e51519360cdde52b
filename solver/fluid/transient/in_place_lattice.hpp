#pragma once
// The lattice Boltzmann equation in time on a box of cells between two moving walls in y, periodic in x and
// z: the equation of PopulationGrid::step, solved with one set of populations instead of two.
//
// Streaming in place (Bailey et al. 2009, the "AA" pattern). The storage alternates from step to step. The
// population q that streams into a cell x is stored
//   streamed   in the cell x itself, array q
//   collided   in the cell x - e_q that it comes from, in the array of the opposite direction
// A step reads the 19 populations of a cell, collides them, and writes each one to the address from which the
// population of the opposite direction was read. The populations are then in the other kind of storage. In a
// step each number is read and written once, by one cell only. So an update of a cell moves 2 x 19 numbers,
// the memory is half of that of two sets, and cells may be updated in any order by any number of threads with
// the same result, bit for bit.
//
// Half-way bounce-back needs no further memory: the population that a cell receives from the wall is read
// from the address to which the cell wrote the population of the opposite direction, which moved towards the
// wall.
#include <cstddef>
#include <vector>

#include "solver/fluid/lbm/collision.hpp"
#include "solver/fluid/lbm/populations.hpp"
#include "solver/grid/cell_field.hpp"
#include "solver/grid/huge_pages.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

struct LatticeSettings {
  MrtRates rates;
  double nu_lu;        ///< lattice viscosity of the ambient fluid
  double wall_speed;   ///< of the upper wall along x, lattice units; the lower wall moves the other way
  double inertia = 1;  ///< see collide()
};

/// \tparam Real  float or double: the type of the populations and of the arithmetic of the collision
template <class Real>
class InPlaceLattice {
 public:
  /// \param box  the cells of the domain, numbered from 0
  InPlaceLattice(const IndexBox& box, const LatticeSettings& settings);

  /// One time step.
  void step();

  /// Couette flow u_x proportional to y, with its viscous stress.
  void set_couette();
  /// Force on the fluid and viscosity, lattice units. The fields must outlive the lattice. Null: no force,
  /// the ambient viscosity.
  void set_force(const VectorField* force) { force_ = force; }
  void set_viscosity(const ScalarField* nu_lu) { viscosity_ = nu_lu; }

  const IndexBox& box() const { return box_; }
  /// The populations of a row of cells before collision: 19 arrays of nx numbers, one after the other.
  void read_row(int y, int z, std::vector<Real>& populations) const;
  /// u = j + F/2 (eq. 18) in the cells of the field's box, lattice units.
  void velocity(VectorField& u) const;

  void save(StateArchive& archive) const;
  void load(const StateArchive& archive);

 private:
  enum class Storage { streamed, collided };
  struct RowCoefficients;
  using Row = PopulationRow<Real>;

  Real* array(int q, int y, int z);
  bool comes_from_wall(int q, int y) const;
  bool wraps(int q, int y) const { return d3q19::e[q].x != 0 && !comes_from_wall(q, y); }
  Real* population(int q, int y, int z);
  const Real* population(int q, int y, int z) const {
    return const_cast<InPlaceLattice*>(this)->population(q, y, z);
  }
  void step_row(int y, int z, RowCoefficients& coefficients);
  void add_momentum_from_walls(int y, const Row& row) const;
  void take_from_ghosts(int y, const Row& row) const;
  void put_into_ghosts(int y, const Row& row) const;

  LatticeSettings settings_;
  IndexBox box_;
  std::size_t row_stride_, array_stride_;
  // State, which a checkpoint holds
  std::vector<Real, HugePageAllocator<Real>> populations_;
  Storage storage_ = Storage::streamed;
  // Inputs of a step
  const VectorField* force_ = nullptr;
  const ScalarField* viscosity_ = nullptr;
};

extern template class InPlaceLattice<float>;
extern template class InPlaceLattice<double>;

}  // namespace capstan
