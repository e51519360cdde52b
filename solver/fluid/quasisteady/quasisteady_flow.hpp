#pragma once
// Steady flow at every instant (the paper's method, section III) on a composite grid, which is fine around
// the capsule only; for a symmetric capsule on a quarter of it. With the time derivative
// (time_derivative.hpp) the flow is unsteady, at the same cost: it starts as the undisturbed shear flow and
// is solved for once a step.
//
// Differs from the paper: the free moments have the relaxation rate 1, or where the viscosity varies there
// are two rates, so that density and momentum are the only unknowns (moment_sweep.hpp, link_sweep.hpp); the
// fine grid covers only the surroundings of the capsule; a solve starts from an extrapolation in time; cycles
// stop on an estimate of the error.
#include <optional>
#include <vector>

#include "solver/coupling/viscosity_field.hpp"
#include "solver/fluid/flow_model.hpp"
#include "solver/fluid/quasisteady/composite_boxes.hpp"
#include "solver/fluid/quasisteady/membrane_coupling.hpp"
#include "solver/fluid/quasisteady/moment_grid.hpp"

namespace capstan {

struct QuasisteadyOptions {
  double dx = 0.1;                    ///< finest spacing / a
  double box = 12.8;                  ///< edge of the domain / a
  double Re = 0.05;                   ///< 0: no convection
  double V = 1;                       ///< viscosity ratio
  std::optional<double> volume = {};  ///< that is kept; none: only the flow through the membrane is zero
  double tolerance = 1e-3;            ///< estimated relative error of the velocities of the membrane
  bool is_uniform = false;            ///< the finest grid covers the whole domain
  bool is_unsteady = false;           ///< with the time derivative; then every solve must be at a later time
};

/// \tparam T  float or double: the type of the numbers on the grids
template <class T>
class QuasisteadyFlow : public FlowModel {
 public:
  /// \param orbits  the symmetry of the capsule, which all positions passed to solve() must have; without
  ///                symmetry the whole domain is solved for
  QuasisteadyFlow(const TriangleMesh& mesh, Orbits orbits, const QuasisteadyOptions& options);

  FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

  /// One multigrid cycle, for measurements. solve() must have been called before.
  void cycle();
  const std::vector<MomentGrid<T>>& grids() const { return grids_; }

 private:
  bool put_membrane(const Points& positions);
  void move_boxes(const IndexBox& capsule);
  void make_grids(const std::vector<IndexBox>& boxes);
  FlowReport start_undisturbed(double kt, const Points& positions, Points& velocities);
  void put_viscosity(const Points& positions);
  void clear_forces(double kt);
  void put_forces(const Points& forces);
  void put_half_force();
  void extrapolate_to(double kt);
  void vertex_velocities(Points& velocities);
  void forget_flow();
  FlowReport cycle_until_converged(Points& velocities);

  QuasisteadyOptions options_;
  Domain domain_;
  MembraneCoupling coupling_;
  std::optional<ViscosityField> viscosity_;  ///< none for V = 1
  // State: a checkpoint stores it together with the state of each grid
  std::vector<IndexBox> boxes_;
  std::vector<MomentGrid<T>> grids_;  ///< finest first; none before the first solve
  std::vector<double> solved_at_;     ///< kt of the last two solves, or fewer
  double first_contraction_ = 0.3;    ///< contraction factor of the first cycle, measured in an earlier solve
  // Scratch of a solve
  ScalarField ratio_;       ///< of the viscosity to the ambient one, on the finest grid near the capsule
  VectorField force_;       ///< of the membrane in the same cells
  VectorField half_force_;  ///< force / (2 ratio)
  VectorField velocity_;    ///< in the same cells
};

}  // namespace capstan
