#pragma once
// Numbers in the cells around the capsule: forces, velocities and viscosities are needed nowhere else.
#include <array>
#include <cstddef>
#include <vector>

namespace capstan {

/// Cells lo <= (x, y, z) < lo + size with N components, one array a component; rows along x are contiguous.
template <int N>
class CellBox {
 public:
  void reset(std::array<int, 3> lo, std::array<int, 3> size, double value = 0) {
    lo_ = lo;
    size_ = size;
    data_.assign(N * cells(), value);
  }

  std::array<int, 3> lo() const { return lo_; }
  std::array<int, 3> size() const { return size_; }
  bool has_row(int y, int z) const {
    return y >= lo_[1] && y < lo_[1] + size_[1] && z >= lo_[2] && z < lo_[2] + size_[2];
  }
  /// The cell x = lo[0] of a row.
  double* row(int component, int y, int z) { return data_.data() + offset(component, y, z); }
  const double* row(int component, int y, int z) const { return data_.data() + offset(component, y, z); }

  const std::vector<double>& values() const { return data_; }

  template <class Visit>  // visit(y, z)
  void for_each_row(Visit visit) const {
    for (int z = lo_[2]; z < lo_[2] + size_[2]; ++z)
      for (int y = lo_[1]; y < lo_[1] + size_[1]; ++y) visit(y, z);
  }

 private:
  std::size_t cells() const { return std::size_t(size_[0]) * size_[1] * size_[2]; }
  std::size_t offset(int component, int y, int z) const {
    return component * cells() + (std::size_t(z - lo_[2]) * size_[1] + (y - lo_[1])) * size_[0];
  }
  std::array<int, 3> lo_{}, size_{};
  std::vector<double> data_;
};

/// The same numbers on a grid of twice the spacing: means over eight children; those outside of the box count
/// as `outside`. The parent of cell i is floor(i/2), for negative indices too.
inline CellBox<1> coarsened(const CellBox<1>& fine, double outside) {
  std::array<int, 3> lo{}, size{};
  for (int c = 0; c < 3; ++c) {
    lo[c] = fine.lo()[c] >> 1;
    size[c] = ((fine.lo()[c] + fine.size()[c] + 1) >> 1) - lo[c];
  }
  CellBox<1> coarse;
  coarse.reset(lo, size, outside);
  fine.for_each_row([&](int y, int z) {
    double* row = coarse.row(0, y >> 1, z >> 1) - lo[0];
    for (int i = 0, x = fine.lo()[0]; i < fine.size()[0]; ++i, ++x)
      row[x >> 1] += (fine.row(0, y, z)[i] - outside) / 8;
  });
  return coarse;
}

using ScalarBox = CellBox<1>;
using VectorBox = CellBox<3>;

/// sum += factor * term in the cells that both boxes have.
void add_scaled(double factor, const VectorBox& term, VectorBox& sum);

/// sum |u - v| / sum |u| over the cells of two boxes of equal size (paper eq. 26).
double relative_difference(const VectorBox& u, const VectorBox& v);

}  // namespace capstan
