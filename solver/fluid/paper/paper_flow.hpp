#pragma once
// The paper's own solution of the steady flow at every instant (section III): 19 populations on a uniform
// grid, with the paper's lattice viscosity and relaxation rates, and W-cycles until the velocity changes by
// less than a tolerance (eq. 26). It is slow, and kept for comparison; QuasisteadyFlow is used otherwise.
#include <vector>

#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/lbm/lattice_coupling.hpp"
#include "solver/fluid/paper/population_grid.hpp"

namespace capstan {

struct PaperOptions {
  double dx = 0.1;          ///< spacing / a
  double box = 12.8;        ///< edge of the domain / a
  double Re = 0.05;         ///< > 0
  double V = 1;             ///< viscosity ratio
  double tolerance = 1e-5;  ///< relative change of the velocity by a cycle (eq. 26)
};

class PaperFlow : public FlowModel {
 public:
  PaperFlow(const TriangleMesh& mesh, const PaperOptions& options);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

 private:
  void put_viscosity(ScalarField nu_lu);
  FlowReport cycle_until_converged(Points& velocities);
  VectorField grid_velocity() const;

  double tolerance_;
  std::vector<PopulationGrid> grids_;  ///< finest first
  LatticeCoupling coupling_;
};

}  // namespace capstan
