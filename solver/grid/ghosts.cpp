#include "solver/grid/ghosts.hpp"

#include <algorithm>
#include <cassert>

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

/// Fills the ghosts at both ends of every row, ghost rows included, if x is periodic.
template <class T>
void fill_row_ends(RowField<T>& field, const std::array<SideRule, 2>& rules) {
  if (rules[0] != SideRule::periodic) return;
  const int n = field.box().size(0);
  for_each_row_in_order(grown(field.box(), 1), [&](int y, int z) {
    for (int k = 0; k < field.components(); ++k) {
      T* row = field.row(k, y, z);
      row[-1] = row[n - 1];
      row[n] = row[0];
    }
  });
}

/// The ghost rows of one side, and the rows of which they are images. A row starts with its first ghost, as
/// in RowField.
template <class T>
struct Layer {
  const T* original;         ///< first row
  T* ghost;                  ///< first row
  std::ptrdiff_t stride;     ///< from row to row, of both
  std::ptrdiff_t component;  ///< from one component of a row to the next, of both
  int rows;
  int length;  ///< numbers of one component of a row, with padding
};

/// Copies all components.
template <class T>
void copy_layer(const Layer<T>& layer, int components) {
  const bool is_contiguous = layer.component == layer.length;
  const int copies = is_contiguous ? 1 : components,
            numbers = is_contiguous ? components * layer.length : layer.length;
  for (int k = 0; k < copies; ++k)
    for (int row = 0; row < layer.rows; ++row) {
      const std::ptrdiff_t at = k * layer.component + row * layer.stride;
      std::copy_n(layer.original + at, numbers, layer.ghost + at);
    }
}

template <class T>
CAPSTAN_VECTOR_UNITS void put_images(const Layer<T>& layer, std::span<const ImageComponent> image) {
  for (int row = 0; row < layer.rows; ++row)
    for (std::size_t k = 0; k < image.size(); ++k) {
      const T* __restrict from = layer.original + row * layer.stride + image[k].of * layer.component;
      T* __restrict to = layer.ghost + row * layer.stride + std::ptrdiff_t(k) * layer.component;
      const T sign = T(image[k].sign);
      for (int i = 0; i < layer.length; ++i) to[i] = sign * from[i];
    }
}

/// Writes the images of all components, with each row reversed in x.
/// \param count  numbers of one component of a row, without padding
template <class T>
CAPSTAN_VECTOR_UNITS void put_reversed_images(const Layer<T>& layer, std::span<const ImageComponent> image,
                                              int count) {
  for (int row = 0; row < layer.rows; ++row)
    for (std::size_t k = 0; k < image.size(); ++k) {
      const T* __restrict from =
          layer.original + row * layer.stride + image[k].of * layer.component + count - 1;
      T* __restrict to = layer.ghost + row * layer.stride + std::ptrdiff_t(k) * layer.component;
      const T sign = T(image[k].sign);
      // Beyond `count` this reads numbers of other rows and writes them into the padding, where they do not
      // matter.
      for (int i = 0; i < layer.length; ++i) to[i] = sign * from[-i];
    }
}

/// Index, along the axis, of the ghosts of a side.
int ghost_index(const IndexBox& box, int axis, int side) {
  return side == 0 ? box.lo[axis] - 1 : box.hi[axis];
}

/// Index, along the axis, of the cells of which the ghosts of a side are images.
int original_index(const IndexBox& box, int axis, int side, SideRule rule) {
  const bool is_adjacent = rule != SideRule::periodic;
  return (side == 0) == is_adjacent ? box.lo[axis] : box.hi[axis] - 1;
}

/// The rows at index `from` of one field and at index `to` of another over the same box, along the axis y or
/// z.
template <class T>
Layer<T> layer_of(const RowField<T>& from_field, RowField<T>& field, int axis, int from, int to) {
  const IndexBox& box = field.box();
  const Strides& strides = field.strides();
  const int y = box.lo[1] - 1, z = box.lo[2] - 1;
  const bool is_y = axis == 1;
  return {.original = (is_y ? from_field.row(0, from, z) : from_field.row(0, y, from)) - 1,
          .ghost = (is_y ? field.row(0, to, z) : field.row(0, y, to)) - 1,
          .stride = is_y ? strides.z : strides.y,
          .component = strides.component,
          .rows = box.size(is_y ? 2 : 1) + 2,
          .length = field.row_length()};
}

template <class T>
void fill_side(RowField<T>& field, int axis, int side, SideRule rule, const Images& images) {
  if (rule == SideRule::interpolated) return;
  const IndexBox& box = field.box();
  const Layer<T> layer =
      layer_of(field, field, axis, original_index(box, axis, side, rule), ghost_index(box, axis, side));
  if (rule == SideRule::periodic) return copy_layer(layer, field.components());
  const auto image = rule == SideRule::wall     ? images.wall
                     : rule == SideRule::mirror ? images.mirror
                                                : images.half_turn;
  assert(int(image.size()) == field.components());
  if (rule == SideRule::half_turn)
    put_reversed_images(layer, image, box.size(0) + 2);
  else
    put_images(layer, image);
}

}  // namespace

// The axes are filled one after the other. The rows copied along y and z include the ghosts of the axes
// before, so that the ghosts at edges and corners are correct, too.
template <class T>
void fill_ghosts(RowField<T>& field, const SideRules& rules, const Images& images) {
  fill_row_ends(field, rules.side[0]);
  for (int axis : {1, 2})
    for (int side : {0, 1}) fill_side(field, axis, side, rules.side[axis][side], images);
}

template <class T>
void copy_interpolated(const RowField<T>& from, RowField<T>& to, const SideRules& rules) {
  for (int axis : {1, 2})
    for (int side : {0, 1}) {
      if (rules.side[axis][side] != SideRule::interpolated) continue;
      const int at = ghost_index(from.box(), axis, side);
      copy_layer(layer_of(from, to, axis, at, at), to.components());
    }
}

template void fill_ghosts(RowField<float>&, const SideRules&, const Images&);
template void fill_ghosts(RowField<double>&, const SideRules&, const Images&);
template void copy_interpolated(const RowField<float>&, RowField<float>&, const SideRules&);
template void copy_interpolated(const RowField<double>&, RowField<double>&, const SideRules&);

}  // namespace capstan
