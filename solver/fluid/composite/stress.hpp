#pragma once
// Stresses where the viscosity is not the ambient one: see sweep.hpp.
#include <vector>

#include "solver/coupling/cell_box.hpp"
#include "solver/fluid/composite/ghosts.hpp"

namespace capstan {

/// Cells first <= x < last of one row; empty when equal.
struct RowSpan {
  int first = 0, last = 0;
  bool empty() const { return first >= last; }
};

/// P, and c = 1 - s, on one grid. Both live in the cells that `span` tells; elsewhere all is zero.
template <class T>
class StressField {
 public:
  StressField(const IndexBox& box, const SideRules& rules, double couette_stress);

  /// New viscosities over ambient ones, 1 outside of `viscosity`. Spans are the cells of another viscosity,
  /// with all that stand next to one and their siblings: those that a coarser grid asks for.
  void set_viscosity(const ScalarBox& viscosity);

  void clear_defect();

  /// Q = c (P + P of the undisturbed flow), ghosts included.
  void update_q();

  RowSpan span(int y, int z) const { return spans_[row_index(y, z)]; }

  template <class Visit>  // visit(span, y, z)
  void for_each_span(Visit visit) const {
    const IndexBox& box = c.box();
    for (int z = box.lo[2]; z < box.hi[2]; ++z)
      for (int y = box.lo[1]; y < box.hi[1]; ++y)
        if (!span(y, z).empty()) visit(span(y, z), y, z);
  }

  // Between this grid and the coarser one, after the moments: see Grid.
  void restrict_to(StressField& coarse) const;
  void take_defect(StressField& fine);
  void correct_from(const StressField& coarse);
  /// The stresses of another box's cells, where both have them.
  void copy_from(const StressField& other);

  /// Linear in time: P <- P + weight (P - before), before <- P.
  void extrapolate(double weight) { extrapolate_field(p, before, weight); }

  /// P, its next values, its values at the last solve and at the start of a multigrid visit, its defect; Q.
  RowField<T> p, out, before, start, defect, q;
  RowField<T> c;  ///< 1 - s

 private:
  std::size_t row_index(int y, int z) const {
    const IndexBox& box = c.box();
    return std::size_t(z - box.lo[2]) * box.size(1) + std::size_t(y - box.lo[1]);
  }
  std::vector<RowSpan> find_spans() const;
  void clear_outside(const std::vector<RowSpan>& spans);

  SideRules rules_;
  T couette_stress_;
  std::vector<RowSpan> spans_;
};

}  // namespace capstan
