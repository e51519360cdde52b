#pragma once
// Flow in a cube whose lid moves, by the paper's multigrid method (section III, fig. 2): 19 populations, FAS
// W-cycles. It measures how the number of cycles depends on the relaxation factor gamma.
//
// Collision, transfers and the cycle are those of PaperFlow. Only the walls differ: here all six sides are at
// rest but the lid, the upper side of y, which moves along x.
#include <optional>
#include <vector>

#include "solver/fluid/paper/population_transfer.hpp"
#include "solver/grid/cell_field.hpp"

namespace capstan {

struct CavitySettings {
  MrtRates rates = kPaperRates;
  double nu_lu = 0.04;   ///< lattice viscosity
  double lid_speed = 0;  ///< along x, lattice units
  double inertia = 1;    ///< see collide()
  double gamma = 0.8;    ///< relaxation factor of eq. 20
};

/// One grid of the cavity. Its equation is f - S(f) = D, as in PopulationGrid.
class CavityGrid {
 public:
  /// \param cells  along an edge
  CavityGrid(int cells, const CavitySettings& settings);

  // The operations of a FasLevel (full_approximation.hpp):
  void relax();
  void restrict_to(CavityGrid& coarse);
  void correct_from(CavityGrid& coarse);

  const IndexBox& box() const { return f_.box(); }
  /// u = sum_q e_q f_q in all cells, lattice units.
  VectorField velocity() const;
  /// Sum over all cells of the deviation of the density from 1; 0 at the start.
  double excess_mass() const;

 private:
  void sweep(double keep, double blend);
  void collide_row(int y, int z);
  void stream_row(int y, int z, double keep, double blend);
  void take_defect(const RowField<double>& fine_residual);

  CavitySettings settings_;
  PopulationTransfer transfer_;
  RowField<double> f_, collided_, next_;  ///< next_: result of a sweep, the next f or a residual
  struct CoarseProblem {
    RowField<double> defect;  ///< D
    RowField<double> start;   ///< I f of the finer grid
  };
  std::optional<CoarseProblem> coarse_;  ///< none on the finest grid
};

/// The finest grid, whose edge has a power of two of cells, and its coarser ones down to 4 cells.
std::vector<CavityGrid> make_cavity_grids(int cells, const CavitySettings& settings);

/// The number of W-cycles from rest until the velocity changes by less than each tolerance in a cycle (eq.
/// 26).
struct CavityCycles {
  std::vector<std::optional<int>> until;  ///< none: not within the largest number of cycles
  double contraction;                     ///< of this change, by the last cycle
};

/// \param cells       along an edge, a power of two
/// \param Re          lid speed times edge over viscosity
/// \param tolerances  in falling order
CavityCycles count_cavity_cycles(int cells, double Re, double gamma, const std::vector<double>& tolerances,
                                 int max_cycles);

}  // namespace capstan
