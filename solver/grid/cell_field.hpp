#pragma once
// Double precision numbers in the cells of a box, without ghost cells. Used for the forces, velocities and
// viscosities around the capsule.
#include <cstddef>
#include <vector>

#include "solver/grid/index_box.hpp"

namespace capstan {

/// N numbers (components) in each cell of a box. One array a component; rows along x are contiguous.
template <int N>
class CellField {
 public:
  /// Redefines the field over another box, with `value` everywhere.
  void reset(const IndexBox& box, double value = 0) {
    box_ = box;
    data_.assign(N * cells(), value);
  }

  const IndexBox& box() const { return box_; }
  /// The cell x = box().lo[0] of a row.
  double* row(int component, int y, int z) { return data_.data() + offset(component, y, z); }
  const double* row(int component, int y, int z) const { return data_.data() + offset(component, y, z); }

  Strides strides() const {
    const std::ptrdiff_t y = box_.size(0), z = y * box_.size(1);
    return {z * box_.size(2), y, z};
  }

  const std::vector<double>& values() const { return data_; }

 private:
  std::size_t cells() const { return std::size_t(box_.cells()); }
  std::size_t offset(int component, int y, int z) const {
    return component * cells() +
           (std::size_t(z - box_.lo[2]) * box_.size(1) + (y - box_.lo[1])) * box_.size(0);
  }
  IndexBox box_;
  std::vector<double> data_;
};

using ScalarField = CellField<1>;
using VectorField = CellField<3>;

/// The field on a grid of twice the spacing: each cell has the mean of its eight children. Children outside
/// of the fine box count with the value `outside`.
ScalarField coarsened(const ScalarField& fine, double outside);

/// sum += factor * term, in the cells that both fields have.
void add_scaled(double factor, const VectorField& term, VectorField& sum);

/// sum |u - v| / sum |u| over the cells of two fields over one box (paper eq. 26).
double relative_difference(const VectorField& u, const VectorField& v);

}  // namespace capstan
