#include "runner/render/membrane_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace capstan {
namespace {

/// An edge that crosses the plane: from the vertex below it to the vertex above it. A vertex in the plane
/// counts as above, so that no edge has a crossing at both ends and none is met twice.
using Crossing = std::pair<int, int>;

class Section {
 public:
  Section(std::span<const double> positions, std::span<const int> triangles) : positions_(positions) {
    for (std::size_t face = 0; face + 2 < triangles.size(); face += 3)
      add_triangle(triangles.subspan(face, 3));
  }

  std::vector<ClosedCurve> curves() {
    std::vector<ClosedCurve> found;
    while (!next_.empty()) found.push_back(take_curve(next_.begin()->first));
    return found;
  }

 private:
  double z(int vertex) const { return positions_[3 * std::size_t(vertex) + 2]; }
  bool is_above(int vertex) const { return z(vertex) >= 0; }

  /// The plane enters an oriented triangle across one edge and leaves it across another.
  void add_triangle(std::span<const int> corners) {
    Crossing in{-1, -1}, out{-1, -1};
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = corners[i], to = corners[(i + 1) % 3];
      if (is_above(from) && !is_above(to)) in = {to, from};
      if (!is_above(from) && is_above(to)) out = {from, to};
    }
    if (in.first >= 0) next_[in] = out;
  }

  ClosedCurve take_curve(Crossing at) {
    ClosedCurve curve;
    for (auto found = next_.find(at); found != next_.end(); found = next_.find(at)) {
      curve.push_back(place_of(at));
      at = found->second;
      next_.erase(found);
    }
    return curve;
  }

  PlanePoint place_of(const Crossing& edge) const {
    const double* below = &positions_[3 * std::size_t(edge.first)];
    const double* above = &positions_[3 * std::size_t(edge.second)];
    const double share = above[2] / (above[2] - below[2]);
    return {above[0] + share * (below[0] - above[0]), above[1] + share * (below[1] - above[1])};
  }

  std::span<const double> positions_;
  std::map<Crossing, Crossing> next_;
};

}  // namespace

std::vector<ClosedCurve> section_in_plane_of_shear(std::span<const double> positions,
                                                   std::span<const int> triangles) {
  return Section(positions, triangles).curves();
}

std::size_t marker_vertex(std::span<const double> positions) {
  constexpr double kInPlane = 1e-6;
  const std::size_t count = positions.size() / 3;
  const auto height = [&](std::size_t vertex) { return std::abs(positions[3 * vertex + 2]); };
  const auto along = [&](std::size_t vertex) { return positions[3 * vertex] + positions[3 * vertex + 1]; };
  double smallest = height(0);
  for (std::size_t vertex = 1; vertex < count; ++vertex) smallest = std::min(smallest, height(vertex));
  std::size_t best = count;
  for (std::size_t vertex = 0; vertex < count; ++vertex)
    if (height(vertex) <= smallest + kInPlane && (best == count || along(vertex) > along(best)))
      best = vertex;
  return best;
}

}  // namespace capstan
