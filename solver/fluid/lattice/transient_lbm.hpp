#pragma once
// The standard method: the lattice Boltzmann equation in time, one lattice step a membrane step (paper
// section VI and VIII: the baseline of Table I, and the model for Re >= 0.1).
#include <vector>

#include "solver/case/case.hpp"
#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/lattice/lattice_coupling.hpp"
#include "solver/fluid/lattice/level.hpp"

namespace capstan {

class TransientLbm : public FlowModel {
 public:
  TransientLbm(const Case& c, const TriangleMesh& mesh);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  std::optional<double> imposed_time_step() const override { return kdt_; }
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

 private:
  double kdt_;
  std::vector<Level> level_;  ///< one: the finest and only grid
  LatticeCoupling coupling_;
};

}  // namespace capstan
