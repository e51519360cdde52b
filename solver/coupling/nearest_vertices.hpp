#pragma once
// The nearest vertex of a membrane to each cell of a box.
#include <vector>

#include "solver/grid/index_box.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

class NearestVertices {
 public:
  static constexpr int kNone = -1;

  /// Finds the nearest vertex to each cell of `box`; kNone for cells farther than `reach` from all vertices.
  /// \param positions  3 x #V, in cells: the centre of the cell i is at i
  /// \param reach      in cells
  void find(const Points& positions, double reach, const IndexBox& box);

  /// The nearest vertices, or kNone, of a row of cells, from x = box.lo[0] on.
  const int* row(int y, int z) const { return nearest_.data() + offset(y, z); }

 private:
  std::size_t offset(int y, int z) const {
    return (std::size_t(z - box_.lo[2]) * box_.size(1) + (y - box_.lo[1])) * pitch_;
  }

  IndexBox box_;
  std::size_t pitch_ = 0;         ///< distance between rows, with a vector register of unused numbers
  std::vector<float> distance2_;  ///< squared, in cells, to the nearest vertex; scratch of find()
  std::vector<int> nearest_;
};

}  // namespace capstan
