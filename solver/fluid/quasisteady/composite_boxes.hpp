#pragma once
// The boxes of the grids of a composite grid. The finest grid covers a box around the capsule. Each coarser
// grid, of twice the spacing, covers a larger box; as soon as a box would have more than 0.7 of the domain's
// cells, the grid and all coarser ones cover the whole domain.
#include <vector>

#include "solver/grid/ghosts.hpp"

namespace capstan {

/// The cube of fluid between two walls in y, periodic in x and z, and the part of it that is solved for.
struct Domain {
  int cells;        ///< along an edge, of the finest spacing
  bool is_quarter;  ///< solve for y, z >= 0 only; the rest follows by the half-turn about z and the mirror z
                    ///< -> -z
  bool is_uniform = false;  ///< every grid covers the whole domain

  /// Number of grids: see halved_cells().
  int grid_count() const;
  /// All cells of a grid's spacing (0 is the finest) that are solved for.
  IndexBox box(int grid) const;
  SideRules rules() const;
};

/// The boxes of all grids, finest first.
/// \param capsule  cells of the finest spacing that the capsule touches, delta functions included
/// \param current  the present boxes, or none. A box is kept while it is large enough and not much too large,
///                 because moving a grid costs time.
std::vector<IndexBox> plan_boxes(const Domain& domain, const IndexBox& capsule,
                                 const std::vector<IndexBox>& current);

}  // namespace capstan
