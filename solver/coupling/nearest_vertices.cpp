#include "solver/coupling/nearest_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

constexpr int kLanes = 8;

/// The cells that may be within reach of a vertex, as offsets from the first cell of the box.
struct Window {
  std::array<int, 3> first, last;  ///< inclusive
  std::array<float, 3> at;         ///< the vertex
  float reach2;                    ///< reach squared
};

/// Assigns to the vertex each cell of the window that is nearer to it than to all vertices before. Without
/// branches, because they would often be mispredicted.
CAPSTAN_VECTOR_UNITS void claim(const Window& window, int vertex, std::size_t y_pitch, std::size_t z_pitch,
                                float* __restrict distance2, int* __restrict nearest) {
  for (int z = window.first[2]; z <= window.last[2]; ++z)
    for (int y = window.first[1]; y <= window.last[1]; ++y) {
      const float dy = float(y) - window.at[1], dz = float(z) - window.at[2], yz2 = dy * dy + dz * dz;
      if (yz2 >= window.reach2) continue;
      const std::size_t row = y * y_pitch + z * z_pitch;
      for (int x = window.first[0]; x <= window.last[0]; x += kLanes) {
        float* __restrict min_distance2 = distance2 + row + x;
        int* __restrict owner = nearest + row + x;
        const float from_first = float(x) - window.at[0];
#pragma omp simd simdlen(kLanes)
        for (int lane = 0; lane < kLanes; ++lane) {
          const float dx = from_first + float(lane), d2 = yz2 + dx * dx, before = min_distance2[lane];
          const int other = owner[lane];
          owner[lane] = d2 < before ? vertex : other;
          min_distance2[lane] = d2 < before ? d2 : before;
        }
      }
    }
}

}  // namespace

void NearestVertices::find(const Points& positions, double reach, const IndexBox& box) {
  box_ = box;
  pitch_ = std::size_t(box.size(0)) + kLanes;
  const float reach2 = float(reach * reach);
  distance2_.assign(pitch_ * box.size(1) * box.size(2), reach2);
  nearest_.assign(distance2_.size(), kNone);
  for (Eigen::Index vertex = 0; vertex < positions.cols(); ++vertex) {
    Window window{.first = {}, .last = {}, .at = {}, .reach2 = reach2};
    for (int axis = 0; axis < 3; ++axis) {
      const double at = positions(axis, vertex) - box.lo[axis];
      window.at[axis] = float(at);
      window.first[axis] = std::max(0, int(std::ceil(at - reach)));
      window.last[axis] = std::min(box.size(axis) - 1, int(std::floor(at + reach)));
    }
    if (window.first[1] > window.last[1] || window.first[2] > window.last[2]) continue;
    claim(window, int(vertex), pitch_, pitch_ * box.size(1), distance2_.data(), nearest_.data());
  }
}

}  // namespace capstan
