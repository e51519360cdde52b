#pragma once
// Stresses on one grid, in and near the cells where the viscosity differs from the ambient one
// (moment_sweep.hpp).
#include <vector>

#include "solver/coupling/viscosity_field.hpp"
#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/fluid/quasisteady/stress_tensor.hpp"
#include "solver/grid/cell_field.hpp"
#include "solver/grid/ghosts.hpp"

namespace capstan {

/// The stress P, the factors c = 1 - s and the stress Q that is passed on. Only some rows are computed; in
/// all others everything is zero.
template <class T>
class StressField {
 public:
  StressField(const IndexBox& box, const SideRules& rules);

  /// Sets c and selects the rows that are computed: rows with a cell whose viscosity differs from the ambient
  /// one, the rows next to them, and all rows that share a coarse parent row with one of these (a coarser
  /// grid averages over them).
  /// \param ratio  of the viscosity to the ambient one; 1 outside of its box
  void set_viscosity(const ScalarField& ratio);
  /// The same for a sharper jump, whose shear stress has the harmonic mean of the viscosity.
  /// \param V  ratio of the inner viscosity to the ambient one
  void set_viscosity(const InterfaceField& interface, double V);

  /// Whether a row is computed.
  bool has(int y, int z) const { return rows_[row_index(y, z)]; }

  /// Computes Q from P, ghosts included.
  /// \param undisturbed  P_xy of the undisturbed flow
  void put_passed_stress(double undisturbed);
  /// The arguments of a sweep over a row of this field and of the moments. The result is written to
  /// scratch_.next. put_passed_stress() must have been called before.
  StressRow<T> row(const FluidRow<T>& fluid, int y, int z, T keep, T blend);
  /// Takes the result of a sweep as the new P.
  void accept_sweep() { std::swap(state_.now, scratch_.next); }

  void clear_defect();
  /// D <- share * (b) of stress_tensor.hpp.
  /// \param zero  moments, all 0
  void put_local_stress(double share, double undisturbed, const RowField<T>& zero, RowField<T>& unused);

  // The parts of a FAS cycle; to be called after the same parts for the moments (see MomentGrid).
  void restrict_to(StressField& coarse) const;
  void take_defect(StressField& fine);
  void take_change();
  void correct_from(const StressField& coarse);

  /// Moves the field to another box. Stresses of the cells that both boxes have are kept.
  void move_to(const IndexBox& box, const SideRules& rules);

  /// Linear extrapolation in time: P <- P + weight (P - P of the last call).
  void extrapolate(double weight);

  /// Kept from one solve to the next, and stored in checkpoints.
  struct State {
    RowField<T> now, before;  ///< P, and that of the last solve
  };
  State& state() { return state_; }
  const State& state() const { return state_; }

 private:
  TensorRow<T> tensor_row(int y, int z, double undisturbed);
  void smooth_defect();
  /// Calls visit(y, z) for the rows of a region that are computed, one after the other.
  template <class Visit>
  void for_each_computed_row(const IndexBox& region, Visit visit) const {
    for_each_row_in_order(region, [&](int y, int z) {
      if (has(y, z)) visit(y, z);
    });
  }
  const IndexBox& box() const { return interface_.box(); }
  std::size_t row_index(int y, int z) const {
    return std::size_t(z - box().lo[2]) * box().size(1) + std::size_t(y - box().lo[1]);
  }
  void select_rows(const std::vector<char>& has_other_viscosity);
  std::vector<char> rows_near(const std::vector<char>& rows) const;
  void clear_rows_outside(const std::vector<char>& rows);

  SideRules rules_;
  State state_;
  // Inputs of a solve
  RowField<T> interface_;          ///< c, c_H - c and the normal
  std::vector<char> rows_;         ///< whether each row is computed
  std::vector<char> has_normals_;  ///< whether each row is near the membrane
  RowField<T> defect_;  ///< D of the stresses: the defect correction of the finer grid; on the finest one,
                        ///< (b) of stress_tensor.hpp
  /// Valid within one cycle only.
  struct Scratch {
    RowField<T> next;    ///< result of a sweep: the next P, or a residual
    RowField<T> start;   ///< first I P of the finer grid, then the change P - I P
    RowField<T> passed;  ///< Q, or c P'
  } scratch_;
};

}  // namespace capstan
