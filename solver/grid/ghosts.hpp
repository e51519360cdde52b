#pragma once
// What stands around a box: a rule a side, as data.
#include <array>
#include <span>

#include "solver/grid/row_field.hpp"

namespace capstan {

enum class SideRule {
  interpolated,  ///< from the next coarser grid; kept until that changes
  periodic,      ///< the cells at the other end (both sides of an axis)
  wall,          ///< fluid at rest half a cell outside: the neighbour with its momentum reversed
  mirror,        ///< of z: the neighbour, with what points along z reversed
  half_turn,     ///< about z, at y = 0: the cell at (-x, -y) with what points along x or y reversed
};

/// Rules of the sides low and high of x, y, z.
struct SideRules {
  std::array<std::array<SideRule, 2>, 3> side;
};

/// How the components of a field look behind a wall, in a mirror and after a half-turn: +1 or -1 each.
struct Parity {
  std::span<const int> wall, mirror, half_turn;
};
extern const Parity kMomentParity, kStressParity, kScalarParity;

/// Fills the ghosts of all sides but the interpolated ones, edges and corners included.
template <class T>
void fill_ghosts(RowField<T>& field, const SideRules& rules, const Parity& parity);

/// Copies the ghost rows of the interpolated sides of y and z (those of x stand in the rows of cells).
template <class T>
void copy_interpolated(const RowField<T>& from, RowField<T>& to, const SideRules& rules);

}  // namespace capstan
