#pragma once
// The 19 populations of a box of cells, one array a direction, with a layer of ghost cells around the box.
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/fluid/lbm/d3q19.hpp"

namespace capstan {

/// Cells along x, y, z.
struct Extent {
  int nx = 0, ny = 0, nz = 0;
  bool operator==(const Extent&) const = default;
  std::size_t cells() const { return std::size_t(nx) * ny * nz; }
  Extent halved() const { return {nx / 2, ny / 2, nz / 2}; }
};

/// The image inside of an index that lies at most one cell beyond the ends of n cells.
inline int periodic(int index, int n) { return index < 0 ? index + n : index >= n ? index - n : index; }

/// One number a cell; x from -1 to nx (likewise y, z) with the ghosts. Rows along x are contiguous.
class CellField {
 public:
  CellField() = default;
  explicit CellField(Extent extent, double value = 0)
      : extent_(extent), data_(Extent{extent.nx + 2, extent.ny + 2, extent.nz + 2}.cells(), value) {}

  Extent extent() const { return extent_; }
  /// The cell x = 0 of a row.
  double* row(int y, int z) { return data_.data() + offset(y, z); }
  const double* row(int y, int z) const { return data_.data() + offset(y, z); }
  std::span<double> data() { return data_; }
  std::span<const double> data() const { return data_; }
  bool empty() const { return data_.empty(); }

 private:
  std::size_t offset(int y, int z) const {
    return (std::size_t(z + 1) * (extent_.ny + 2) + (y + 1)) * (extent_.nx + 2) + 1;
  }
  Extent extent_;
  std::vector<double> data_;
};

class PopulationField {
 public:
  PopulationField() = default;
  explicit PopulationField(Extent extent) { populations_.fill(CellField(extent)); }

  Extent extent() const { return populations_[0].extent(); }
  CellField& operator[](int q) { return populations_[q]; }
  const CellField& operator[](int q) const { return populations_[q]; }
  bool empty() const { return populations_[0].empty(); }

 private:
  std::array<CellField, d3q19::kQ> populations_;
};

/// The deviation of the density of one cell, and its momentum without the force's half.
struct Macroscopic {
  double rho, jx, jy, jz;
};
inline Macroscopic macroscopic(const PopulationField& f, int x, int y, int z) {
  Macroscopic m{};
  for (int q = 0; q < d3q19::kQ; ++q) {
    const double value = f[q].row(y, z)[x];
    m.rho += value;
    m.jx += d3q19::e[q].x * value;
    m.jy += d3q19::e[q].y * value;
    m.jz += d3q19::e[q].z * value;
  }
  return m;
}

}  // namespace capstan
