#pragma once
// One grid of the composite: a box of cells of one spacing, and its equation in moments (sweep.hpp).
//
// What is solved for is the deviation from the undisturbed shear flow u = (y, 0, 0), which solves the same
// equation: so walls are at rest, and the numbers fade away from the capsule. Momentum g is a velocity in
// units of a k on every grid (a linear flow may be scaled); then density, stresses and their residuals are
// proportional to the spacing, and force and the residual of g to its square.
#include <optional>
#include <utility>

#include "solver/fluid/quasisteady/stress.hpp"
#include "solver/fluid/quasisteady/sweep.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// Sweeps over one grid relax in turn with the two, stresses with p.
struct Relaxation {
  double gamma[2];
  double p;
};

template <class T>
class Grid {
 public:
  /// \param domain all cells of this spacing; a grid that covers it has no interpolated sides
  /// \param dx     spacing / a
  Grid(const IndexBox& box, const IndexBox& domain, const SideRules& domain_rules, double dx, double Re,
       bool has_stress, const Relaxation& relaxation);

  const IndexBox& box() const { return f_.box(); }
  bool is_whole() const { return box() == domain_; }

  // The level of fas.hpp.
  void relax();
  void restrict_to(Grid& coarse);
  void correct_from(Grid& coarse);

  /// Viscosity over the ambient one in a box of cells, 1 outside of it.
  void set_viscosity(const ScalarBox& viscosity) { stress_->set_viscosity(viscosity); }

  /// D before a finer grid writes it: no force, and then one that is added in the cells of a box (a k a
  /// sweep).
  void clear_force();
  void add_force(const VectorBox& force);
  /// g <- g + factor force: half a force lies between momentum and velocity.
  void add_momentum(double factor, const VectorBox& force);
  /// The part of convection that is kept over a solve (convection.hpp), from the flow as it stands.
  void add_convection();

  /// Linear in time: f <- f + weight (f - before), before <- f.
  void extrapolate(double weight);

  /// The same grid over another box. What was not covered, and its ghosts, are interpolated from the coarser
  /// grid.
  void move_to(const IndexBox& box, Grid& coarse);

  /// g in the cells of a box inside this grid (units a k, without the shear flow).
  void momentum(VectorBox& box) const;

  /// Everything the next solve depends on.
  template <class Self, class Visit>  // Self: Grid or const Grid; visit(name, RowField<T>&), const likewise
  static void visit_state(Self& grid, Visit visit) {
    visit("f", grid.f_), visit("before", grid.before_);
    if (grid.stress_) visit("p", grid.stress_->p), visit("p_before", grid.stress_->before);
  }

 private:
  void sweep(double keep, double blend, double p_keep, double p_blend);
  void sweep_residual() { sweep(-1, 1, -1, 1); }
  void take_defect(Grid& fine);
  void take_change();
  IndexBox covered_stencils(const Grid& fine) const;
  void subtract_mean_mass_defect();
  void interpolate_ghosts(const Grid& coarse);
  IndexBox with_interpolated_ghosts(IndexBox box) const;
  SideRules rules_of(const IndexBox& box) const;

  IndexBox domain_;
  SideRules domain_rules_;
  double dx_;
  double inertia_;  ///< Re nu dx / a
  Relaxation relaxation_;
  int sweep_parity_ = 0;
  SideRules rules_;
  RowField<T> f_, out_, defect_, start_, before_;
  std::optional<StressField<T>> stress_;
};

}  // namespace capstan
