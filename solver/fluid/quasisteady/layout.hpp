#pragma once
// Which cells the grids of a composite cover: the finest a box around the capsule, each next one, of twice
// the spacing, a larger box, until a box would be most of the domain; from there on grids cover the whole
// domain.
#include <vector>

#include "solver/grid/ghosts.hpp"

namespace capstan {

/// The cube of fluid between two walls, and how much of it is solved for.
struct Domain {
  int cells;        ///< of the finest spacing along an edge
  bool is_quarter;  ///< only y, z >= 0: the rest is its image by the half-turn about z and the mirror z -> -z
  bool is_uniform = false;  ///< every grid covers the whole domain

  /// How many grids there are (halved_cells).
  int grid_count() const;
  IndexBox box(int grid) const;
  SideRules rules() const;
};

/// The boxes of all grids, finest first.
/// \param capsule  cells of the finest spacing that the capsule touches, delta functions included
/// \param current  the boxes so far (or none), kept where they still fit: what does not move costs nothing
std::vector<IndexBox> plan_boxes(const Domain& domain, const IndexBox& capsule,
                                 const std::vector<IndexBox>& current);

}  // namespace capstan
