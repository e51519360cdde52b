#pragma once
// The paper's flow model: at every step the steady lattice Boltzmann equation is solved by FAS multigrid, for
// the membrane's forces at that instant (sections III and VI).
#include <vector>

#include "solver/case/case.hpp"
#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/lattice/lattice_coupling.hpp"
#include "solver/fluid/lattice/level.hpp"

namespace capstan {

/// Rates, lattice viscosity and relaxation that the case's scheme and viscosity ratio ask for.
LevelSettings quasisteady_settings(const Case& c);

class QuasisteadyLbm : public FlowModel {
 public:
  QuasisteadyLbm(const Case& c, const TriangleMesh& mesh);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

 private:
  void extrapolate_to(double kt);
  FlowReport cycle_until_converged(Points& velocities);
  double relative_change(const Points& velocities);
  VectorBox grid_velocity() const;

  Fidelity fidelity_;
  std::vector<Level> levels_;
  LatticeCoupling coupling_;
  PopulationField previous_;       ///< the solution before the last one, for the extrapolation in time
  std::vector<double> solved_at_;  ///< kt of the last solutions, oldest first, two at most
  double contraction_ = 0.5;       ///< of the velocity's change from cycle to cycle, as last seen
  Points last_velocities_;         ///< at the vertices, before the last cycle
  VectorBox last_grid_velocity_;   ///< scheme paper: in all cells, before the last cycle
};

}  // namespace capstan
