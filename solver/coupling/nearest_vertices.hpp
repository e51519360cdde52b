#pragma once
// For the cells of a box near a membrane: which of its vertices is nearest.
#include <array>
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

class NearestVertices {
 public:
  static constexpr int kNone = -1;

  /// \param positions in cells: cell i has its centre at i
  /// \param reach     cells; who is farther from all vertices has none
  /// \param lo, size  the box
  void find(const Points& positions, double reach, std::array<int, 3> lo, std::array<int, 3> size);

  /// The vertices of a row of cells, x = lo[0] ..., or kNone.
  const int* row(int y, int z) const { return nearest_.data() + offset(y, z); }

 private:
  std::size_t offset(int y, int z) const {
    return (std::size_t(z - lo_[2]) * size_[1] + (y - lo_[1])) * pitch_;
  }

  std::array<int, 3> lo_{}, size_{};
  std::size_t pitch_ = 0;  ///< of a row, with a register's width beyond its end
  std::vector<float> distance2_;
  std::vector<int> nearest_;
};

}  // namespace capstan
