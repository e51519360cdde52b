#pragma once
// A few numbers (components) in each cell of a box and in one layer of ghost cells around it.
//
// Memory: rows along x are contiguous and start with their ghost cell. The order of the rows depends on the
// layout.
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/grid/for_each_row.hpp"
#include "solver/grid/huge_pages.hpp"

namespace capstan {

/// Number of single precision numbers in a cache line, and also in the widest vector register.
inline constexpr int kLanes = 16;
/// `numbers` rounded up to whole vector registers.
constexpr int whole_lanes(int numbers) { return (numbers + kLanes - 1) / kLanes * kLanes; }

enum class Layout {
  /// The components of a row follow each other, so that a sweep over a row reads from few separate streams of
  /// memory. Rows start at cache lines and are padded to whole cache lines: loops over them use whole vector
  /// registers. The values in the padding are meaningless.
  components_in_rows,
  /// One array for each component, for fields of so many components that a row would not fit into the
  /// first-level cache.
  separate_components,
};

template <class T>
class RowField {
 public:
  RowField(const IndexBox& box, int components, Layout layout = Layout::components_in_rows)
      : components_(components), layout_(layout) {
    reset(box);
  }

  /// Redefines the field over another box, zero everywhere. Reuses its memory if that is large enough.
  void reset(const IndexBox& box) {
    box_ = box;
    const std::ptrdiff_t ny = box.size(1) + 2, nz = box.size(2) + 2;
    if (layout_ == Layout::components_in_rows) {
      row_length_ = whole_lanes(box.size(0) + 2);
      strides_ = {row_length_, row_length_ * components_, row_length_ * components_ * ny};
      data_.assign(std::size_t(strides_.z * nz) + kLanes, T(0));
    } else {
      row_length_ = box.size(0) + 2;
      strides_ = {separate_stride(row_length_ * ny * nz), row_length_, row_length_ * ny};
      data_.assign(std::size_t(strides_.component * components_), T(0));
    }
  }

  const IndexBox& box() const { return box_; }
  int components() const { return components_; }

  /// The first cell inside the box, x = box().lo[0], of a row. Its ghosts have the offsets -1 and
  /// box().size(0).
  T* row(int component, int y, int z) { return data_.data() + offset(component, y, z); }
  const T* row(int component, int y, int z) const { return data_.data() + offset(component, y, z); }

  const Strides& strides() const { return strides_; }
  /// Numbers of one component of a row, with ghosts and padding.
  int row_length() const { return int(row_length_); }

  /// All components of a row, with ghosts and padding. Requires Layout::components_in_rows.
  std::span<T> whole_row(int y, int z) { return {row(0, y, z) - 1, std::size_t(strides_.y)}; }
  std::span<const T> whole_row(int y, int z) const { return {row(0, y, z) - 1, std::size_t(strides_.y)}; }

  std::span<T> data() { return data_; }
  std::span<const T> data() const { return data_; }

 private:
  /// Distance from one of the separate arrays to the next, in numbers: a multiple of 4096 bytes plus three
  /// cache lines. Without these lines all components of a cell would be in the same set of the cache.
  static std::ptrdiff_t separate_stride(std::ptrdiff_t numbers) {
    constexpr std::ptrdiff_t kPage = 4096 / sizeof(T);
    return (numbers + kPage - 1) / kPage * kPage + 3 * kNumbersPerLine<T>;
  }
  std::size_t offset(int component, int y, int z) const {
    return std::size_t(z - box_.lo[2] + 1) * strides_.z + std::size_t(y - box_.lo[1] + 1) * strides_.y +
           std::size_t(component) * strides_.component + 1;
  }

  IndexBox box_;
  int components_;
  Layout layout_;
  std::ptrdiff_t row_length_ = 0;
  Strides strides_{};
  std::vector<T, HugePageAllocator<T>> data_;
};

/// Copies all components in a region of cells that both fields have, inside their boxes or as ghosts.
template <class T>
void copy_cells(const RowField<T>& from, RowField<T>& to, const IndexBox& region) {
  for_each_row_in_order(region, [&](int y, int z) {
    for (int k = 0; k < to.components(); ++k)
      std::copy_n(from.row(k, y, z) + (region.lo[0] - from.box().lo[0]), region.size(0),
                  to.row(k, y, z) + (region.lo[0] - to.box().lo[0]));
  });
}

/// Copies the cells that both boxes have, without ghosts.
template <class T>
void copy_cells(const RowField<T>& from, RowField<T>& to) {
  copy_cells(from, to, intersection(from.box(), to.box()));
}

// The following functions act elementwise on whole fields or whole rows.

/// Linear extrapolation in time: now <- now + weight (now - before), before <- old value of now.
void extrapolate(std::span<float> now, std::span<float> before, double weight);
void extrapolate(std::span<double> now, std::span<double> before, double weight);

/// start <- now - start.
void take_difference(std::span<const float> now, std::span<float> start);
void take_difference(std::span<const double> now, std::span<double> start);

/// sum <- sum + (a - b) in a region of cells of three fields over one box.
template <class T>
void add_difference(const RowField<T>& a, const RowField<T>& b, RowField<T>& sum, const IndexBox& region);

}  // namespace capstan
