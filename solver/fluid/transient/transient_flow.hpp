#pragma once
// The standard method: the lattice Boltzmann equation in time, one lattice step for each step of the membrane
// (paper, sections VI and VIII: the baseline of Table I, and the model for Re >= 0.1).
#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/lbm/lattice_coupling.hpp"
#include "solver/fluid/transient/in_place_lattice.hpp"

namespace capstan {

/// \tparam Real  float or double: the type of the populations
template <class Real>
class TransientFlow : public FlowModel {
 public:
  TransientFlow(const TriangleMesh& mesh, const LatticeOptions& options);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  std::optional<double> imposed_time_step() const override { return kdt_; }
  void save(StateArchive& archive) const override { lattice_.save(archive); }
  void load(const StateArchive& archive) override { lattice_.load(archive); }

 private:
  double kdt_;
  InPlaceLattice<Real> lattice_;
  LatticeCoupling coupling_;
};

extern template class TransientFlow<float>;
extern template class TransientFlow<double>;

}  // namespace capstan
