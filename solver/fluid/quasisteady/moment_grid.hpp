#pragma once
// One grid of the composite grid: a box of cells of one spacing, and the lattice Boltzmann equation in
// moments on it (moment_sweep.hpp).
//
// The unknowns are deviations from the undisturbed shear flow u = (y, 0, 0), which solves the same equation.
// So walls are at rest, and the unknowns decay with the distance from the capsule. The momentum g is a
// velocity in units of a k on every grid (the equation is linear, so any unit serves). Then density, stresses
// and their residuals are proportional to the spacing; forces and the residual of g are proportional to its
// square.
#include <optional>
#include <span>

#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/fluid/quasisteady/stress_field.hpp"
#include "solver/fluid/quasisteady/time_derivative.hpp"

namespace capstan {

/// Relaxation factors of one sweep.
struct SweepRelaxation {
  double gamma;  ///< of density and momentum
  double p;      ///< of stresses
  ThinFluidFactors thin = {};
};

/// Relaxation factors of the sweeps over a grid. The two entries are for alternate sweeps.
struct Relaxation {
  SweepRelaxation everywhere[2];
  /// Further sweeps after each sweep, over the rows with stresses only.
  std::span<const SweepRelaxation> rows_with_stress[2] = {};
};

template <class T>
class MomentGrid {
 public:
  /// \param domain        all cells of this spacing; at sides of `box` inside the domain, ghosts are
  ///                      interpolated
  /// \param domain_rules  rules of the sides of the domain
  /// \param dx            spacing / a
  /// \param has_stress    whether the viscosity differs from the ambient one anywhere
  MomentGrid(const IndexBox& box, const IndexBox& domain, const SideRules& domain_rules, double dx, double Re,
             bool has_stress, const Relaxation& relaxation);

  const IndexBox& box() const { return state_.now.box(); }
  /// Whether the grid covers the whole domain.
  bool is_whole() const { return box() == domain_; }

  // The operations of a FasLevel (full_approximation.hpp):
  void relax();
  void restrict_to(MomentGrid& coarse);
  void correct_from(MomentGrid& coarse);

  /// Ratio of the viscosity to the ambient one, in the cells of the field's box; 1 elsewhere.
  void set_viscosity(const ScalarField& ratio) { stress_->set_viscosity(ratio); }
  /// The same for the finest grid (StressField).
  void set_viscosity(const InterfaceField& interface, double V) { stress_->set_viscosity(interface, V); }

  /// Puts a share of (b) of stress_tensor.hpp into D of the stresses, on the finest grid.
  void put_local_stress(double share);

  /// D <- 0.
  void clear_force();
  /// Makes the equation that of unsteady flow, with this backward difference, and adds to D the part of the
  /// time derivative that is known. To be called after clear_force(), while the moments of this grid are
  /// those of the last solve.
  void add_time_derivative(const BackwardDifference& difference);
  /// D <- D + force, in the cells of the field's box (units a k per sweep).
  void add_force(const VectorField& force);
  /// Adds to D the part of convection that is kept constant during a solve (convection.hpp), computed from
  /// the present flow.
  void add_convection();
  /// g <- g + factor * force. (The velocity is u = g - F/2.)
  void add_momentum(double factor, const VectorField& force);

  /// Linear extrapolation in time: moments <- moments + weight (moments - moments of the last call). In
  /// unsteady flow the weight of the density is smaller, and add_time_derivative() precedes.
  void extrapolate(double weight);

  /// Moves the grid to another box. Cells that it did not cover before, and its ghosts, are interpolated from
  /// the coarser grid.
  void move_to(const IndexBox& box, MomentGrid& coarse);

  /// g in the cells of the field's box, which must be inside this grid (units a k, without the shear flow).
  void momentum(VectorField& g) const;

  /// Calls visit(name, RowField<T>&) for everything that the next solve depends on.
  /// \tparam Self  MomentGrid, or const MomentGrid for const fields
  template <class Self, class Visit>
  static void visit_state(Self& grid, Visit visit) {
    visit("f", grid.state_.now), visit("before", grid.state_.before);
    if (grid.stress_) visit("p", grid.stress_->state().now), visit("p_before", grid.stress_->state().before);
  }

 private:
  /// keep and blend (moment_sweep.hpp) of density, momentum and stresses.
  struct SweepWeights {
    double keep, blend;
    double g_keep, g_blend;
    double p_keep, p_blend;
    ThinFluidFactors thin = {};
  };
  SweepWeights weights_of(const SweepRelaxation& relaxation) const {
    const double gamma = relaxation.gamma, p = relaxation.p;
    return {1 - gamma, gamma, 1 - gamma, gamma / (1 + rate_), 1 - p, p, relaxation.thin};
  }
  void sweep(const SweepWeights& weights);
  void sweep_stress_row(int y, int z, const FluidRow<T>& fluid, const SweepWeights& weights);
  void relax_everywhere(const SweepRelaxation& relaxation);
  void relax_rows_with_stress(const SweepRelaxation& relaxation);
  FluidRow<T> fluid_row(int y, int z, const SweepWeights& weights);
  /// scratch_.next <- residual S(m) + D - m, and likewise of the stresses.
  void sweep_residual() { sweep({-1, 1, -1 - rate_, 1, -1, 1}); }
  double density_weight(double weight) const;
  void take_defect(MomentGrid& fine);
  void take_change();
  IndexBox covered_stencils(const MomentGrid& fine) const;
  void subtract_mean_mass_defect();
  void interpolate_ghosts(const MomentGrid& coarse);
  IndexBox with_interpolated_ghosts(IndexBox box) const;
  SideRules rules_of(const IndexBox& box) const;

  IndexBox domain_;
  SideRules domain_rules_;
  double dx_;
  double inertia_;   ///< Re nu dx / a
  double rate_ = 0;  ///< of unsteady flow: Re nu dx^2 alpha_0
  Relaxation relaxation_;
  int sweep_parity_ = 0;  ///< index of the gamma of the next sweep; 0 at the start of every solve, because
                          ///< each visit has an even number of sweeps
  SideRules rules_;

  /// Kept from one solve to the next, and stored in checkpoints.
  struct State {
    RowField<T> now, before;  ///< moments, and those of the last solve
  } state_;
  RowField<T>
      defect_;  ///< D: force, convection and, where a finer grid covers this one, its defect correction
  /// Valid within one cycle only.
  struct Scratch {
    RowField<T> next;   ///< result of a sweep: the next moments, or a residual
    RowField<T> start;  ///< first I m of the finer grid, then the change m - I m
  } scratch_;
  std::optional<StressField<T>> stress_;
};

}  // namespace capstan
