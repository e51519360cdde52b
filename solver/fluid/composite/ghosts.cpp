#include "solver/fluid/composite/ghosts.hpp"

#include <algorithm>

#include "solver/coupling/vector_units.hpp"

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

template <class T>
CAPSTAN_VECTOR_UNITS void copy_row(const T* from, T* to, int count, int sign) {
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) to[i] = T(sign) * from[i];
}

template <class T>
CAPSTAN_VECTOR_UNITS void copy_reversed(const T* from, T* to, int count, int sign) {
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) to[i] = T(sign) * from[count - 1 - i];
}

/// Sides x: the two ends of every row, ghost rows included.
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

/// One ghost row, its ends included, from the row it is an image of.
template <class T>
void fill_row(RowField<T>& field, const Parity& parity, SideRule rule, std::array<int, 2> ghost,
              std::array<int, 2> image) {
  if (rule == SideRule::interpolated) return;
  const int count = field.box().size(0) + 2;
  for (int k = 0; k < field.components(); ++k) {
    const T* from = field.row(k, image[0], image[1]) - 1;
    T* to = field.row(k, ghost[0], ghost[1]) - 1;
    switch (rule) {
      case SideRule::interpolated:
        break;
      case SideRule::periodic:
        copy_row(from, to, count, 1);
        break;
      case SideRule::wall:
        copy_row(from, to, count, parity.wall[k]);
        break;
      case SideRule::mirror:
        copy_row(from, to, count, parity.mirror[k]);
        break;
      case SideRule::half_turn:
        copy_reversed(from, to, count, parity.half_turn[k]);
        break;
    }
  }
}

/// The index whose image stands in the ghost layer of a side.
int image_index(const IndexBox& box, int axis, int side, SideRule rule) {
  const bool same_end = rule != SideRule::periodic;
  return (side == 0) == same_end ? box.lo[axis] : box.hi[axis] - 1;
}

}  // namespace

const Parity kMomentParity = {kMomentsAtWall, kMomentsInMirror, kMomentsTurned};
const Parity kStressParity = {kStressesAtWall, kStressesInMirror, kStressesTurned};

template <class T>
void fill_ghosts(RowField<T>& field, const SideRules& rules, const Parity& parity) {
  const IndexBox& box = field.box();
  fill_row_ends(field, rules.side[0]);
  for (int side : {0, 1}) {
    const SideRule rule = rules.side[1][side];
    const int ghost = side == 0 ? box.lo[1] - 1 : box.hi[1], image = image_index(box, 1, side, rule);
    for (int z = box.lo[2] - 1; z <= box.hi[2]; ++z) fill_row(field, parity, rule, {ghost, z}, {image, z});
  }
  for (int side : {0, 1}) {
    const SideRule rule = rules.side[2][side];
    const int ghost = side == 0 ? box.lo[2] - 1 : box.hi[2], image = image_index(box, 2, side, rule);
    for (int y = box.lo[1] - 1; y <= box.hi[1]; ++y) fill_row(field, parity, rule, {y, ghost}, {y, image});
  }
}

template void fill_ghosts(RowField<float>&, const SideRules&, const Parity&);
template void fill_ghosts(RowField<double>&, const SideRules&, const Parity&);

}  // namespace capstan
