#pragma once
// Stresses where the viscosity is not the ambient one: see sweep.hpp.
#include <vector>

#include "solver/grid/cell_box.hpp"
#include "solver/grid/ghosts.hpp"

namespace capstan {

/// P, and c = 1 - s, on one grid. Both live in the rows that `has` tells; elsewhere all is zero.
template <class T>
class StressField {
 public:
  StressField(const IndexBox& box, const SideRules& rules);

  /// New viscosities over ambient ones, 1 outside of `viscosity`. Stresses live in the rows with a cell of
  /// another viscosity, in all that stand next to one, and in their siblings: those that a coarser grid asks
  /// for.
  void set_viscosity(const ScalarBox& viscosity);

  bool has(int y, int z) const { return rows_[row_index(y, z)]; }

  /// visit(y, z) for the rows of a region that have stresses.
  template <class Visit>
  void for_each_row(const IndexBox& region, Visit visit) const {
    for (int z = region.lo[2]; z < region.hi[2]; ++z)
      for (int y = region.lo[1]; y < region.hi[1]; ++y)
        if (has(y, z)) visit(y, z);
  }

  void clear_defect();
  void fill_ghosts();

  // Between this grid and the coarser one, after the moments: see Grid.
  void restrict_to(StressField& coarse) const;
  void take_defect(StressField& fine);
  void take_change();
  void correct_from(const StressField& coarse);
  /// Keeps the stresses of the cells that both boxes have.
  void move_to(const IndexBox& box, const SideRules& rules);

  /// Linear in time: P <- P + weight (P - before), before <- P.
  void extrapolate(double weight);

  /// P, its next values, its values at the last solve and at the start of a multigrid visit, its defect.
  RowField<T> p, out, before, start, defect;
  RowField<T> c;  ///< 1 - s, with ghosts

 private:
  std::size_t row_index(int y, int z) const {
    const IndexBox& box = c.box();
    return std::size_t(z - box.lo[2]) * box.size(1) + std::size_t(y - box.lo[1]);
  }
  std::vector<char> rows_near(const std::vector<char>& rows) const;
  void clear_rows_outside(const std::vector<char>& rows);

  SideRules rules_;
  std::vector<char> rows_;
};

}  // namespace capstan
