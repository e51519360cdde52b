#include "solver/coupling/nearest_vertices.hpp"

#include <algorithm>
#include <cmath>

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

constexpr int kLanes = 8;

/// The cells of a box, from `lo` on; those that a vertex may claim are `first` to `last` of it.
struct Window {
  std::array<int, 3> first, last;
  std::array<float, 3> at;  ///< of the vertex
  float reach2;
};

/// Without a branch: whether a cell is nearer to this vertex than to the others before it, nobody can guess.
CAPSTAN_VECTOR_UNITS void claim(const Window& window, int vertex, std::size_t y_pitch, std::size_t z_pitch,
                                float* __restrict distance2, int* __restrict nearest) {
  for (int z = window.first[2]; z <= window.last[2]; ++z)
    for (int y = window.first[1]; y <= window.last[1]; ++y) {
      const float dy = float(y) - window.at[1], dz = float(z) - window.at[2], yz2 = dy * dy + dz * dz;
      if (yz2 >= window.reach2) continue;
      const std::size_t row = y * y_pitch + z * z_pitch;
      for (int x = window.first[0]; x <= window.last[0]; x += kLanes) {
        float* __restrict least = distance2 + row + x;
        int* __restrict owner = nearest + row + x;
        const float from_first = float(x) - window.at[0];
#pragma omp simd simdlen(kLanes)
        for (int lane = 0; lane < kLanes; ++lane) {
          const float dx = from_first + float(lane), d2 = yz2 + dx * dx, before = least[lane];
          const int other = owner[lane];
          owner[lane] = d2 < before ? vertex : other;
          least[lane] = d2 < before ? d2 : before;
        }
      }
    }
}

}  // namespace

void NearestVertices::find(const Points& positions, double reach, std::array<int, 3> lo,
                           std::array<int, 3> size) {
  lo_ = lo, size_ = size;
  pitch_ = std::size_t(size[0] + kLanes);
  const float reach2 = float(reach * reach);
  distance2_.assign(pitch_ * size[1] * size[2], reach2);
  nearest_.assign(distance2_.size(), kNone);
  for (Eigen::Index vertex = 0; vertex < positions.cols(); ++vertex) {
    Window window{.first = {}, .last = {}, .at = {}, .reach2 = reach2};
    for (int axis = 0; axis < 3; ++axis) {
      const double at = positions(axis, vertex) - lo[axis];
      window.at[axis] = float(at);
      window.first[axis] = std::max(0, int(std::ceil(at - reach)));
      window.last[axis] = std::min(size[axis] - 1, int(std::floor(at + reach)));
    }
    if (window.first[1] > window.last[1] || window.first[2] > window.last[2]) continue;
    claim(window, int(vertex), pitch_, pitch_ * size[1], distance2_.data(), nearest_.data());
  }
}

}  // namespace capstan
