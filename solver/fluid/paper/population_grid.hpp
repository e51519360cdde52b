#pragma once
// One grid of the paper's multigrid method: the 19 populations of a box of cells between two moving walls in
// y, periodic in x and z.
//
// The grid's equation is f - S(f) = D, where S is one collision and streaming step (paper eq. 13) and D is
// zero on the finest grid; see full_approximation.hpp. The walls are at the faces of the box, half a cell
// outside of the outermost cell centres, by half-way bounce-back.
#include <optional>
#include <utility>
#include <vector>

#include "solver/fluid/lbm/collision.hpp"
#include "solver/fluid/paper/population_transfer.hpp"
#include "solver/grid/cell_field.hpp"
#include "solver/grid/ghosts.hpp"

namespace capstan {

struct PopulationGridSettings {
  MrtRates rates;
  double nu_lu;        ///< lattice viscosity of the ambient fluid
  double wall_speed;   ///< of the upper wall along x, lattice units; the lower wall moves the other way
  double inertia = 1;  ///< see collide()
  double gamma = 1;    ///< relaxation factor of eq. 20
};

class PopulationGrid {
 public:
  /// \param box  the cells of the domain, numbered from 0
  PopulationGrid(const IndexBox& box, const PopulationGridSettings& settings);

  /// f <- S(f): one time step of the transient method.
  void step() { sweep(0, 1), std::swap(f_, next_); }

  // The operations of a FasLevel (full_approximation.hpp):
  void relax() { sweep(1 - settings_.gamma, settings_.gamma), std::swap(f_, next_); }
  void restrict_to(PopulationGrid& coarse);
  void correct_from(PopulationGrid& coarse);

  /// Couette flow u_x proportional to y, with its viscous stress.
  void set_couette();

  /// Force on the fluid, lattice units. The field must outlive this grid. Null: no force.
  void set_force(const VectorField* force) { force_ = force; }

  /// Viscosity in the cells of the field's box, lattice units. All other cells have the ambient one.
  void set_viscosity(const ScalarField& nu_lu);

  const IndexBox& box() const { return f_.box(); }
  RowField<double>& populations() { return f_; }
  const RowField<double>& populations() const { return f_; }

  /// u = j + F/2 (eq. 18) in the cells of the field's box, lattice units.
  void velocity(VectorField& u) const;
  /// Root mean square of the residual over cells and populations.
  double residual_norm();

 private:
  struct RowBuffer;
  void sweep(double keep, double blend);
  void collide_row(int y, int z, RowBuffer& row) const;
  void stream_row(int y, int z, const RowBuffer& row, double keep, double blend);
  void bounce_back(int q, int y, int z, const RowBuffer& row, double keep, double blend);
  void gather_force(int y, int z, RowBuffer& row) const;
  void sweep_residual();
  void take_defect(const RowField<double>& fine_residual);
  const double* defect_row(int q, int y, int z) const {
    return coarse_ ? coarse_->defect.row(q, y, z) : nullptr;
  }

  PopulationGridSettings settings_;
  PopulationTransfer transfer_;

  RowField<double> f_;  ///< the state: the next solve starts from it, and a checkpoint holds it

  // Inputs of a solve
  const VectorField* force_ = nullptr;
  std::optional<RowField<double>>
      s_nu_;                ///< relaxation rates of the stress; none while all cells have the ambient one
  IndexBox viscosity_box_;  ///< outside of it s_nu_ is the ambient rate
  std::vector<double> ambient_s_nu_;  ///< a row of the ambient rate, with ghosts

  // Scratch
  RowField<double> next_;  ///< result of a sweep: the next f, or a residual
  struct CoarseProblem {
    RowField<double> defect;  ///< D
    RowField<double> start;   ///< I f of the finer grid
  };
  std::optional<CoarseProblem> coarse_;  ///< set by the finer grid at each visit; none on the finest grid
};

/// The finest grid and its coarser ones, each of half as many cells along an edge, until an edge has 4 cells
/// or an odd number.
std::vector<PopulationGrid> make_population_grids(const IndexBox& finest,
                                                  const PopulationGridSettings& settings);

}  // namespace capstan
