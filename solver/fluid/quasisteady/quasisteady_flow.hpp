#pragma once
// Steady flow at every instant (the paper's method, section III) on a composite of grids around the capsule,
// and on a quarter of them where the capsule is symmetric.
//
// Differs from the paper: the populations' free moments are relaxed at once (sweep.hpp), the fine grid covers
// the capsule alone, the solution starts from an extrapolation in time, and cycles stop on an estimate of the
// error.
#include <vector>

#include "solver/coupling/viscosity_field.hpp"
#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/quasisteady/grid.hpp"
#include "solver/fluid/quasisteady/layout.hpp"
#include "solver/fluid/quasisteady/symmetric_boundary.hpp"

namespace capstan {

struct CompositeOptions {
  double dx = 0.1;          ///< finest spacing / a
  double box = 12.8;        ///< edge of the domain / a
  double Re = 0.05;         ///< 0: without convection
  double V = 1;             ///< viscosity ratio
  double tolerance = 1e-3;  ///< relative error of the vertices' velocities
  bool is_uniform = false;  ///< the finest grid covers the whole domain
};

/// \tparam T of the numbers on the grids: float or double
template <class T>
class QuasisteadyFlow : public FlowModel {
 public:
  QuasisteadyFlow(const TriangleMesh& mesh, Orbits orbits, const CompositeOptions& options);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

  /// One multigrid cycle; a solve takes as many as it needs. After the first solve.
  void cycle();
  const std::vector<Grid<T>>& grids() const { return grids_; }

 private:
  bool put_membrane(const Points& positions);
  void follow(const IndexBox& capsule);
  void make_grids(const std::vector<IndexBox>& boxes);
  void put_viscosity(const Points& positions);
  void put_forces(const Points& forces);
  void extrapolate_to(double kt);
  void vertex_velocities(const Points& positions, Points& velocities);
  void forget_flow();
  FlowReport cycle_until_converged(const Points& positions, Points& velocities);

  CompositeOptions options_;
  Domain domain_;
  SymmetricBoundary boundary_;
  std::optional<ViscosityField> viscosity_;  ///< none for V = 1
  std::vector<IndexBox> boxes_;
  std::vector<Grid<T>> grids_;      ///< finest first; none before the first solve
  VectorBox force_;                 ///< of the membrane on the finest grid
  VectorBox velocity_;              ///< workspace: in the same cells
  std::vector<double> solved_at_;   ///< times of the last two solves
  double first_contraction_ = 0.3;  ///< of the error by the first cycle of a solve, as last seen
};

}  // namespace capstan
