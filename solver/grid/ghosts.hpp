#pragma once
// Values of the ghost cells around a box: one rule for each side.
//
// Ghosts behind a wall or a symmetry plane are images of cells inside. The components of the image (a change
// of sign, or another component) depend on the physical quantity, and are given by the caller as Images.
#include <array>
#include <span>

#include "solver/grid/row_field.hpp"

namespace capstan {

enum class SideRule {
  interpolated,  ///< interpolated from the next coarser grid; fill_ghosts() leaves them alone
  periodic,      ///< copies of the cells at the other end (both sides of an axis)
  wall,          ///< of y or z: image of the adjacent cell; the wall is the outer face of this cell
  mirror,        ///< of z: image of the adjacent cell under z -> -z
  half_turn,     ///< of y at y = 0: image of the cell at (-x, -y) under the half-turn about z
};

/// Rules of the low and the high side of x, y and z. Sides of x are periodic or interpolated.
struct SideRules {
  std::array<std::array<SideRule, 2>, 3> side;
};

/// A component of an image: `sign` times the component `of` of the original cell.
struct ImageComponent {
  int of;
  int sign;  ///< +1 or -1
};

/// The components of a field's images behind a wall, under the mirror symmetry and under the half-turn. Empty
/// if the field has no side of this kind.
struct Images {
  std::span<const ImageComponent> wall, mirror, half_turn;
};

/// Fills the ghosts of all sides except the interpolated ones, edges and corners included.
template <class T>
void fill_ghosts(RowField<T>& field, const SideRules& rules, const Images& images);

/// Copies the ghost rows of the interpolated sides of y and z. (Ghosts at the ends of rows of cells are not
/// copied.)
template <class T>
void copy_interpolated(const RowField<T>& from, RowField<T>& to, const SideRules& rules);

}  // namespace capstan
