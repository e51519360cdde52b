#pragma once
// What stands in the ghost cells around a box: rules as data, one an axis.
#include "solver/fluid/lbm/population_field.hpp"

namespace capstan {

enum class GhostRule {
  periodic,  ///< the cells at the other end
  wall,      ///< the neighbouring cell with its populations reversed: density even, momentum odd
};

struct GhostRules {
  GhostRule x = GhostRule::periodic;
  GhostRule y = GhostRule::wall;
  GhostRule z = GhostRule::periodic;
};

/// Fills all ghost cells, edges and corners included.
void fill_ghosts(PopulationField& f, const GhostRules& rules);

}  // namespace capstan
