#pragma once
// One grid of the lattice Boltzmann solution: a box of cells between two moving walls in y, periodic in x and
// z.
//
// The level's equation is f = S(f) + D, where S collides and streams (paper eq. 13) and D is the defect that
// a finer level put there (eq. 24; zero on the finest). Walls are half-way bounce-back, half a cell outside
// the box.
#include <array>
#include <utility>
#include <vector>

#include "solver/fluid/lbm/collision.hpp"
#include "solver/fluid/lbm/population_field.hpp"
#include "solver/fluid/paper/population_ghosts.hpp"
#include "solver/fluid/paper/transfer.hpp"
#include "solver/grid/cell_box.hpp"

namespace capstan {

struct LevelSettings {
  MrtRates rates;
  double nu_lu;        ///< lattice viscosity of the ambient fluid
  double wall_speed;   ///< of the upper wall along x, lattice units; the lower wall moves the other way
  double inertia = 1;  ///< see collide()
  double gamma = 1;    ///< relaxation of eq. 20
};

class Level {
 public:
  Level(Extent extent, const LevelSettings& settings);

  /// f <- S(f): one time step of the transient method.
  void step() { sweep(0, 1), std::swap(f_, scratch_); }

  // The FAS level of fas.hpp.
  void relax() { sweep(1 - settings_.gamma, settings_.gamma), std::swap(f_, scratch_); }
  void restrict_to(Level& coarse);
  void correct_from(Level& coarse);

  /// Couette flow u_x proportional to y, with its viscous stress.
  void set_couette();

  /// Force on the fluid, lattice units; the box stays owned by the caller. Null: no force.
  void set_force(const VectorBox* force) { force_ = force; }

  /// Viscosity in the cells of the box, lattice units; the ambient one elsewhere.
  void set_viscosity(const ScalarBox& nu_lu);
  Extent extent() const { return f_.extent(); }
  const LevelSettings& settings() const { return settings_; }
  PopulationField& populations() { return f_; }
  const PopulationField& populations() const { return f_; }

  /// Velocities in the cells of the box (lattice units): j + F/2 (eq. 18).
  void velocity(VectorBox& box) const;
  /// Root mean square of r(f) = f - S(f) - D over cells and populations.
  double residual_norm();

 private:
  struct RowBuffer;
  void sweep(double keep, double blend);
  void collide_row(int y, int z, RowBuffer& row) const;
  void stream_row(int y, int z, const RowBuffer& row, double keep, double blend);
  void bounce_back(int q, int y, int z, const RowBuffer& row, double keep, double blend);
  void gather_force(int y, int z, RowBuffer& row) const;
  void sweep_residual();
  void take_defect(const PopulationField& fine_residual);

  LevelSettings settings_;
  GhostRules ghosts_;
  LevelTransfer transfer_;
  PopulationField f_, scratch_;
  PopulationField defect_, start_;  ///< D and I f; empty on the finest level
  CellField s_nu_;                  ///< stress rates; empty when the viscosity is the ambient one everywhere
  ScalarBox contrast_;              ///< where s_nu_ differs from the ambient one
  std::vector<double> ambient_s_nu_;  ///< a row of the ambient stress rate
  const VectorBox* force_ = nullptr;
};

/// The finest level and its coarser ones, each of half the extent, down to 4 or an odd number of cells an
/// edge.
std::vector<Level> make_levels(Extent extent, const LevelSettings& settings);

}  // namespace capstan
