#pragma once
// The paper's own solution of the steady flow at every instant (its section III): 19 populations on a uniform
// grid, its lattice viscosity and relaxation rates, W-cycles until the velocity changes no more (eq. 26).
// Slow, and kept for comparison: composite_lbm.hpp is what runs otherwise.
#include <vector>

#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/lbm/lattice_coupling.hpp"

namespace capstan {

class PaperFlow : public FlowModel {
 public:
  PaperFlow(const Case& c, const TriangleMesh& mesh);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

 private:
  FlowReport cycle_until_converged(Points& velocities);
  VectorBox grid_velocity() const;

  double tolerance_;
  std::vector<Level> levels_;  ///< finest first
  LatticeCoupling coupling_;
};

}  // namespace capstan
