#pragma once
// A few numbers (components) in each cell of a box and in one layer of ghost cells around it.
//
// Memory: rows along x are contiguous, and the components of a row follow each other, so that a sweep over a
// row reads its neighbours from few places in memory. A row starts with its ghost cell, at the start of a
// cache line, and is padded to whole cache lines: loops over it use whole vector registers. The values in the
// padding are meaningless.
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/grid/for_each_row.hpp"
#include "solver/grid/huge_pages.hpp"

namespace capstan {

/// Single precision numbers in a cache line and in the widest vector register.
inline constexpr int kLanes = 16;
/// `numbers` rounded up to whole vector registers.
constexpr int whole_lanes(int numbers) { return (numbers + kLanes - 1) / kLanes * kLanes; }

template <class T>
class RowField {
 public:
  RowField(const IndexBox& box, int components) : components_(components) { reset(box); }

  /// Redefines the field over another box, zero everywhere. Reuses its memory if that is large enough.
  void reset(const IndexBox& box) {
    box_ = box;
    pitch_ = whole_lanes(box.size(0) + 2);
    data_.assign(std::size_t(pitch_) * components_ * (box.size(1) + 2) * (box.size(2) + 2) + kLanes, T(0));
  }

  const IndexBox& box() const { return box_; }
  int components() const { return components_; }

  /// The first cell inside the box, x = box().lo[0], of a row. Its ghosts have the offsets -1 and
  /// box().size(0).
  T* row(int component, int y, int z) { return data_.data() + offset(component, y, z); }
  const T* row(int component, int y, int z) const { return data_.data() + offset(component, y, z); }

  Strides strides() const {
    const std::ptrdiff_t y = std::ptrdiff_t(pitch_) * components_;
    return {pitch_, y, y * (box_.size(1) + 2)};
  }

  /// All components of a row, with ghosts and padding.
  std::span<T> whole_row(int y, int z) { return {row(0, y, z) - 1, std::size_t(strides().y)}; }
  std::span<const T> whole_row(int y, int z) const { return {row(0, y, z) - 1, std::size_t(strides().y)}; }

  std::span<T> data() { return data_; }
  std::span<const T> data() const { return data_; }

 private:
  std::size_t offset(int component, int y, int z) const {
    const Strides s = strides();
    return std::size_t(z - box_.lo[2] + 1) * s.z + std::size_t(y - box_.lo[1] + 1) * s.y +
           std::size_t(component) * pitch_ + 1;
  }

  IndexBox box_;
  int components_ = 0, pitch_ = 0;
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

// The following act number by number on whole fields or whole rows.

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
