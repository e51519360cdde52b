#include "solver/grid/ghosts.hpp"

#include <algorithm>

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

//                                 rho  gx  gy  gz
constexpr int kMomentsAtWall[] = {1, -1, -1, -1};
constexpr int kMomentsInMirror[] = {1, 1, 1, -1};
constexpr int kMomentsTurned[] = {1, -1, -1, 1};
//                                  xx yy xy  xz  yz
constexpr int kStressesAtWall[] = {1, 1, 1, 1, 1};
constexpr int kStressesInMirror[] = {1, 1, 1, -1, -1};
constexpr int kStressesTurned[] = {1, 1, 1, -1, -1};
constexpr int kScalar[] = {1};

/// Sides x: the two ends of every row, ghost rows included: those of an interpolated side have no image.
template <class T>
void fill_row_ends(RowField<T>& field, const std::array<SideRule, 2>& rules) {
  if (rules[0] != SideRule::periodic) return;
  const IndexBox& box = field.box();
  const int n = box.size(0);
  for (int z = box.lo[2] - 1; z <= box.hi[2]; ++z)
    for (int y = box.lo[1] - 1; y <= box.hi[1]; ++y)
      for (int k = 0; k < field.components(); ++k) {
        T* row = field.row(k, y, z);
        row[-1] = row[n - 1];
        row[n] = row[0];
      }
}

/// The ghost rows of one side, and the rows that they are images of.
template <class T>
struct Layer {
  const T* image;  ///< where its first row begins (RowField), as the next
  T* ghost;
  std::ptrdiff_t stride;  ///< from row to row
  int rows, length;       ///< of a component of a row, with its padding
};

template <class T>
CAPSTAN_VECTOR_UNITS void copy_layer(const Layer<T>& layer, std::span<const int> signs) {
  for (int row = 0; row < layer.rows; ++row)
    for (std::size_t k = 0; k < signs.size(); ++k) {
      const std::ptrdiff_t at = row * layer.stride + std::ptrdiff_t(k) * layer.length;
      const T* __restrict from = layer.image + at;
      T* __restrict to = layer.ghost + at;
      const T sign = T(signs[k]);
      for (int i = 0; i < layer.length; ++i) to[i] = sign * from[i];
    }
}

/// \param count numbers of a row without its padding
template <class T>
CAPSTAN_VECTOR_UNITS void turn_layer(const Layer<T>& layer, std::span<const int> signs, int count) {
  for (int row = 0; row < layer.rows; ++row)
    for (std::size_t k = 0; k < signs.size(); ++k) {
      const std::ptrdiff_t at = row * layer.stride + std::ptrdiff_t(k) * layer.length;
      const T* __restrict from = layer.image + at + count - 1;
      T* __restrict to = layer.ghost + at;
      const T sign = T(signs[k]);
      // the padding's images stand before the row, in another one's numbers
      for (int i = 0; i < layer.length; ++i) to[i] = sign * from[-i];
    }
}

/// Ghosts of a side of y (all z) or z (all y).
int ghost_index(const IndexBox& box, int axis, int side) {
  return side == 0 ? box.lo[axis] - 1 : box.hi[axis];
}

/// The index whose image stands in the ghost layer of a side.
int image_index(const IndexBox& box, int axis, int side, SideRule rule) {
  const bool same_end = rule != SideRule::periodic;
  return (side == 0) == same_end ? box.lo[axis] : box.hi[axis] - 1;
}

/// The layers at index `from` and `to` of an axis y or z.
template <class T>
Layer<T> layer_of(const RowField<T>& from_field, RowField<T>& field, int axis, int from, int to) {
  const IndexBox& box = field.box();
  const int y = box.lo[1] - 1, z = box.lo[2] - 1, length = int(field.component_stride());
  if (axis == 1)
    return {from_field.row(0, from, z) - 1, field.row(0, to, z) - 1, field.z_stride(), box.size(2) + 2,
            length};
  return {from_field.row(0, y, from) - 1, field.row(0, y, to) - 1, field.y_stride(), box.size(1) + 2, length};
}

}  // namespace

const Parity kMomentParity = {kMomentsAtWall, kMomentsInMirror, kMomentsTurned};
const Parity kStressParity = {kStressesAtWall, kStressesInMirror, kStressesTurned};
const Parity kScalarParity = {kScalar, kScalar, kScalar};

template <class T>
void fill_ghosts(RowField<T>& field, const SideRules& rules, const Parity& parity) {
  constexpr int kKept[] = {1, 1, 1, 1, 1};
  const IndexBox& box = field.box();
  fill_row_ends(field, rules.side[0]);
  for (int axis : {1, 2})
    for (int side : {0, 1}) {
      const SideRule rule = rules.side[axis][side];
      const Layer<T> layer =
          layer_of(field, field, axis, image_index(box, axis, side, rule), ghost_index(box, axis, side));
      switch (rule) {
        case SideRule::interpolated:
          break;
        case SideRule::periodic:
          copy_layer(layer, std::span(kKept).first(field.components()));
          break;
        case SideRule::wall:
          copy_layer(layer, parity.wall);
          break;
        case SideRule::mirror:
          copy_layer(layer, parity.mirror);
          break;
        case SideRule::half_turn:
          turn_layer(layer, parity.half_turn, box.size(0) + 2);
          break;
      }
    }
}

template <class T>
void copy_interpolated(const RowField<T>& from, RowField<T>& to, const SideRules& rules) {
  for (int axis : {1, 2})
    for (int side : {0, 1}) {
      if (rules.side[axis][side] != SideRule::interpolated) continue;
      const int at = ghost_index(from.box(), axis, side);
      const Layer<T> layer = layer_of(from, to, axis, at, at);
      for (int row = 0; row < layer.rows; ++row)
        std::copy_n(layer.image + row * layer.stride, to.y_stride(), layer.ghost + row * layer.stride);
    }
}

template void fill_ghosts(RowField<float>&, const SideRules&, const Parity&);
template void fill_ghosts(RowField<double>&, const SideRules&, const Parity&);
template void copy_interpolated(const RowField<float>&, RowField<float>&, const SideRules&);
template void copy_interpolated(const RowField<double>&, RowField<double>&, const SideRules&);

}  // namespace capstan
