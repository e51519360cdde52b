#include "solver/fluid/quasisteady/moment_sweep.hpp"

#include <algorithm>

#include "solver/grid/row_field.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

// Numbers of a row that are processed at a time: the sums of such a block fit into the first-level cache.
constexpr int kBlock = 256;

/// A part of a row, by indices of its numbers in memory: index 0 is the ghost before the first cell, and the
/// last indices are padding. Ghosts and padding are included so that loops run over whole vector registers;
/// their results are discarded (weights_at()).
struct Block {
  int first, last;  ///< cells first <= i < last are updated
  int from, to;     ///< their populations come from the cells from <= i < to
};

/// The block that starts at `first`, in a row of `numbers` numbers.
[[gnu::always_inline]] inline Block block_at(int first, int numbers) {
  const int last = std::min(first + kBlock, numbers);
  return {first, last, std::max(first - kLanes, 0), std::min(last + kLanes, numbers)};
}

/// keep and blend at the index i of a row: a ghost or padding keeps its value.
template <class T>
struct Weights {
  T keep, blend;
};
template <class T>
[[gnu::always_inline]] inline Weights<T> weights_at(int i, int cells, T keep, T blend) {
  const bool is_cell = unsigned(i - 1) < unsigned(cells);
  return {is_cell ? keep : T(1), is_cell ? blend : T(0)};
}

/// 36 times the moments of the populations that stream from x into one row, for each x of a block. They are
/// summed over this row and the eight rows around it, separately for the directions with e_x = 1 (right), e_x
/// = -1 (left) and e_x = 0 (across).
template <class T>
struct Sent {
  static constexpr int kSums = 3;
  static constexpr int kRoom = kBlock + 2 * kLanes;
  alignas(64) T right[kSums][kRoom], left[kSums][kRoom], across[kSums][kRoom];

  /// Sets the entries next to both ends of the block to zero. At the ends of a row no sums are computed
  /// there, but relax() reads them.
  [[gnu::always_inline]] void begin(const Block& block) {
    for (int k = 0; k < kSums; ++k) right[k][kLanes - 1] = left[k][kLanes + block.last - block.first] = 0;
  }

  /// Stores a sum for e_x = 1 and e_x = -1, given its parts that are even and odd in e_x.
  [[gnu::always_inline]] void send(int k, int at, T even, T odd) {
    right[k][at] = even + odd;
    left[k][at] = even - odd;
  }

  [[gnu::always_inline]] T from_left(int k, int at) const { return right[k][at - 1]; }
  [[gnu::always_inline]] T from_right(int k, int at) const { return left[k][at + 1]; }
  [[gnu::always_inline]] T arrived(int k, int at) const {
    return across[k][at] + (from_left(k, at) + from_right(k, at));
  }
};
/// Factors of the populations in the sums: 1, e_y, e_z. The moment with the factor e_x is the difference of
/// right and left.
enum { kSum, kSumY, kSumZ };

/// The start of a row in memory: the ghost before its first cell.
template <class T>
[[gnu::always_inline]] inline T* begin_of(T* first_cell) {
  return static_cast<T*>(__builtin_assume_aligned(first_cell - 1, 64));
}

/// First half of (b): for each x, sums over the row and the eight rows around it. A
/// population with e_y = +-1 comes from the row y -+ 1, likewise for z. 36 w_i is 12 at rest, 2 along an axis
/// and 1 along a diagonal.
template <class T>
[[gnu::always_inline]] inline void gather(const FluidRow<T>& row, const Block& block, Sent<T>& sent) {
  const Strides& s = row.strides;
  const T* __restrict rho = begin_of(row.m);
  const T *gx = rho + s.component, *gy = gx + s.component, *gz = gy + s.component;
  const int shift = kLanes - block.first;
#pragma GCC ivdep
  for (int i = block.from; i < block.to; ++i) {
    const auto sum = [&](const T* f, std::ptrdiff_t step) { return f[i - step] + f[i + step]; };
    const auto difference = [&](const T* f, std::ptrdiff_t step) { return f[i - step] - f[i + step]; };
    const T even =
        2 * rho[i] + (sum(rho, s.y) + sum(rho, s.z)) + 3 * (difference(gy, s.y) + difference(gz, s.z));
    const T odd = 2 * gx[i] + (sum(gx, s.y) + sum(gx, s.z));
    const T even_y = difference(rho, s.y) + 3 * sum(gy, s.y), odd_y = difference(gx, s.y);
    const T even_z = difference(rho, s.z) + 3 * sum(gz, s.z), odd_z = difference(gx, s.z);
    sent.send(kSum, i + shift, even, 3 * odd);
    sent.send(kSumY, i + shift, even_y, 3 * odd_y);
    sent.send(kSumZ, i + shift, even_z, 3 * odd_z);

    // e_x = 0: the directions (0, +-1, 0) and (0, 0, +-1) have the weight 2, those with e_x = +-1 in the sums
    // above have the weight 1: twice these sums are used. The rest population has the weight 12 = 8 + 2 * 2
    const auto phi = [&](int ey, int ez) {
      const std::ptrdiff_t at = i - ey * s.y - ez * s.z;
      return rho[at] + 3 * (T(ey) * gy[at] + T(ez) * gz[at]);
    };
    const T pp = phi(1, 1), pn = phi(1, -1), np = phi(-1, 1), nn = phi(-1, -1);
    sent.across[kSum][i + shift] = 8 * rho[i] + 2 * even + ((pp + pn) + (np + nn));
    sent.across[kSumY][i + shift] = 2 * even_y + ((pp + pn) - (np + nn));
    sent.across[kSumZ][i + shift] = 2 * even_z + ((pp - pn) + (np - nn));
  }
}

/// Second half of (b): the sums over the populations from x - 1, from x + 1 and from the same x, minus (c);
/// then the relaxation. Ghosts are copied.
template <class T>
[[gnu::always_inline]] inline void relax(const FluidRow<T>& row, const Block& block, const Sent<T>& sent) {
  const std::ptrdiff_t k = row.strides.component;
  const T* __restrict m = begin_of(row.m);
  const T* __restrict d = begin_of(row.defect);
  T* __restrict out = begin_of(row.out);
  const int shift = kLanes - block.first;
#pragma GCC ivdep
  for (int i = block.first; i < block.last; ++i) {
    const Weights<T> of_rho = weights_at(i, row.count, row.keep, row.blend),
                     of_g = weights_at(i, row.count, row.g_keep, row.g_blend);
    const auto put = [&](int j, const Weights<T>& weights, T sum, T carried) {
      const std::ptrdiff_t at = i + j * k;
      out[at] = weights.keep * m[at] + weights.blend * (sum * T(1. / 36) + d[at] - carried);
    };
    const auto carried = [&](int j) { return row.shear * (m[i + 1 + j * k] - m[i - 1 + j * k]); };
    const int from = i + shift;
    put(kRho, of_rho, sent.arrived(kSum, from), 0);
    put(kGx, of_g, sent.from_left(kSum, from) - sent.from_right(kSum, from),
        carried(kGx) + row.lift * m[i + kGy * k]);
    put(kGy, of_g, sent.arrived(kSumY, from), carried(kGy));
    put(kGz, of_g, sent.arrived(kSumZ, from), carried(kGz));
  }
}

template <class T>
[[gnu::always_inline]] inline void sweep(const FluidRow<T>& row) {
  Sent<T> sent;
  const int numbers = whole_lanes(row.count + 2);
  for (int first = 0; first < numbers; first += kBlock) {
    const Block block = block_at(first, numbers);
    sent.begin(block);
    gather(row, block, sent);
    relax(row, block, sent);
  }
}

}  // namespace

CAPSTAN_VECTOR_UNITS void sweep_fluid(const FluidRow<float>& row) { sweep(row); }
CAPSTAN_VECTOR_UNITS void sweep_fluid(const FluidRow<double>& row) { sweep(row); }

}  // namespace capstan
