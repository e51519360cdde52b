#pragma once
// One grid of the composite grid: a box of cells of one spacing, and the lattice Boltzmann equation in
// moments on it (moment_sweep.hpp, and link_sweep.hpp where the viscosity varies).
//
// The unknowns are deviations from the undisturbed shear flow u = (y, 0, 0), which solves the same equation.
// So walls are at rest, and the unknowns decay with the distance from the capsule. The momentum g is a
// velocity in units of a k on every grid (the equation is linear, so any unit serves). Then the density and
// its residual are proportional to the spacing; forces and the residual of g are proportional to its square.
#include <array>
#include <optional>
#include <vector>

#include "solver/fluid/quasisteady/link_sweep.hpp"
#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/fluid/quasisteady/time_derivative.hpp"
#include "solver/grid/cell_field.hpp"
#include "solver/grid/ghosts.hpp"
#include "solver/grid/row_field.hpp"

namespace capstan {

template <class T>
class MomentGrid {
 public:
  /// \param domain        all cells of this spacing; at sides of `box` inside the domain, ghosts are
  ///                      interpolated
  /// \param domain_rules  rules of the sides of the domain
  /// \param dx            spacing / a
  /// \param relaxation    factors of alternate sweeps
  MomentGrid(const IndexBox& box, const IndexBox& domain, const SideRules& domain_rules, double dx, double Re,
             const std::array<double, 2>& relaxation);

  const IndexBox& box() const { return state_.now.box(); }
  /// Whether the grid covers the whole domain.
  bool is_whole() const { return box() == domain_; }

  // The operations of a FasLevel (full_approximation.hpp):
  void relax();
  void restrict_to(MomentGrid& coarse);
  void correct_from(MomentGrid& coarse);

  /// Ratio of the viscosity to the ambient one, in the cells of the field's box; 1 elsewhere. To be called
  /// again after move_to().
  void set_viscosity(const ScalarField& ratio);

  /// D <- 0.
  void clear_force();
  /// Makes the equation that of unsteady flow, with this backward difference, and adds to D the part of the
  /// time derivative that is known. To be called after clear_force(), while the moments of this grid are
  /// those of the last solve.
  void add_time_derivative(const BackwardDifference& difference);
  /// D <- D + force, in the cells of the field's box (units a k per sweep of ambient fluid).
  /// \param half  force / (2 R), by which g is larger than the velocity
  void add_force(const VectorField& force, const VectorField& half);
  /// Adds to D the part of convection that is kept constant during a solve (convection.hpp), computed from
  /// the present flow.
  void add_convection();
  /// g <- g + factor * momentum.
  void add_momentum(double factor, const VectorField& momentum);

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
  }

 private:
  void sweep(std::optional<double> gamma);
  /// scratch_.next <- residual S(m) + D - m.
  void sweep_residual() { sweep({}); }
  FluidRow<T> fluid_row(int y, int z, std::optional<double> gamma);
  LinkRow<T> link_row(int y, int z);
  std::size_t row_index(int y, int z) const {
    return std::size_t(z - box().lo[2]) * box().size(1) + std::size_t(y - box().lo[1]);
  }
  /// The factors of (c) in moment_sweep.hpp.
  double shear(int y) const { return inertia_ * (y + 0.5) * dx_ / 2; }
  double lift() const { return inertia_ * dx_; }
  void add_carried(const VectorField& half);
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
  std::array<double, 2> relaxation_;
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
  std::optional<RowField<T>> ratio_;  ///< of the viscosity to the ambient one; none: 1 everywhere
  std::vector<char> has_ratio_;       ///< whether it differs from 1 in a row or the rows next to it
};

}  // namespace capstan
