#pragma once
// A few numbers a cell over a box of cells with one layer of ghosts around it. Rows along x are contiguous,
// and the components of one row stand behind each other: a sweep meets its neighbours' numbers in few places
// of memory. Rows begin, with the ghost before the first cell, where cache lines do, and are padded to whole
// lines: loops over them take whole vector registers. What the padding holds has no meaning.
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/grid/huge_pages.hpp"
#include "solver/grid/index_box.hpp"

namespace capstan {

/// Numbers of a cache line, and of the widest register, in single precision.
inline constexpr int kLanes = 16;
/// Loops over whole registers need no remainder.
constexpr int whole_lanes(int numbers) { return (numbers + kLanes - 1) / kLanes * kLanes; }

template <class T>
class RowField {
 public:
  RowField(const IndexBox& box, int components) : components_(components) { reset(box); }

  /// Zero, over another box; in the memory it has, where that suffices.
  void reset(const IndexBox& box) {
    box_ = box;
    pitch_ = whole_lanes(box.size(0) + 2);
    data_.assign(std::size_t(pitch_) * components_ * (box.size(1) + 2) * (box.size(2) + 2) + kLanes, T(0));
  }

  const IndexBox& box() const { return box_; }
  int components() const { return components_; }

  /// The first cell inside the box, x = lo[0], of a row; the ghosts stand at -1 and size(0).
  T* row(int component, int y, int z) { return data_.data() + offset(component, y, z); }
  const T* row(int component, int y, int z) const { return data_.data() + offset(component, y, z); }

  /// Distances in memory to the next component, to the rows y + 1 and z + 1.
  std::ptrdiff_t component_stride() const { return pitch_; }
  std::ptrdiff_t y_stride() const { return std::ptrdiff_t(pitch_) * components_; }
  std::ptrdiff_t z_stride() const { return y_stride() * (box_.size(1) + 2); }

  /// All components of a row, with ghosts and padding.
  std::span<T> whole_row(int y, int z) { return {row(0, y, z) - 1, std::size_t(y_stride())}; }
  std::span<const T> whole_row(int y, int z) const { return {row(0, y, z) - 1, std::size_t(y_stride())}; }

  std::span<T> data() { return data_; }
  std::span<const T> data() const { return data_; }

 private:
  std::size_t offset(int component, int y, int z) const {
    return std::size_t(z - box_.lo[2] + 1) * z_stride() + std::size_t(y - box_.lo[1] + 1) * y_stride() +
           std::size_t(component) * pitch_ + 1;
  }

  IndexBox box_;
  int components_ = 0, pitch_ = 0;
  std::vector<T, HugePageAllocator<T>> data_;
};

/// Copies a region of cells that both fields have, in their boxes or ghosts.
template <class T>
void copy_cells(const RowField<T>& from, RowField<T>& to, const IndexBox& region) {
  for (int z = region.lo[2]; z < region.hi[2]; ++z)
    for (int y = region.lo[1]; y < region.hi[1]; ++y)
      for (int k = 0; k < to.components(); ++k)
        std::copy_n(from.row(k, y, z) + (region.lo[0] - from.box().lo[0]), region.size(0),
                    to.row(k, y, z) + (region.lo[0] - to.box().lo[0]));
}

/// The cells that both boxes have (their ghosts not).
template <class T>
void copy_cells(const RowField<T>& from, RowField<T>& to) {
  copy_cells(from, to, intersection(from.box(), to.box()));
}

// Number by number, of whole fields or whole rows.

/// now <- now + weight (now - before), before <- now.
void extrapolate(std::span<float> now, std::span<float> before, double weight);
void extrapolate(std::span<double> now, std::span<double> before, double weight);

/// start <- now - start.
void take_difference(std::span<const float> now, std::span<float> start);
void take_difference(std::span<const double> now, std::span<double> start);

/// sum <- sum + (a - b) in a region of cells of three fields over one box.
template <class T>
void add_difference(const RowField<T>& a, const RowField<T>& b, RowField<T>& sum, const IndexBox& region);

}  // namespace capstan
