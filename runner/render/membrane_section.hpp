#pragma once
// The section of a triangulated membrane with the plane of shear, z = 0.
#include <span>
#include <vector>

namespace capstan {

struct PlanePoint {
  double x, y;  ///< / a

  bool operator==(const PlanePoint&) const = default;
};

/// The points of a closed curve in their order; the first one is not repeated at the end.
using ClosedCurve = std::vector<PlanePoint>;

/// The section of a closed, oriented surface: one curve for a simple capsule, several where a fold crosses
/// the plane apart from the rest, none if the surface does not reach it. \param positions  #V x 3, row by row
/// \param triangles  #F x 3, vertices from 0
std::vector<ClosedCurve> section_in_plane_of_shear(std::span<const double> positions,
                                                   std::span<const int> triangles);

/// The material point that pictures follow: of the vertices in the plane of shear the one that is farthest
/// along the line x = y, which is the major axis of every shape at the start. \param positions  #V x 3, row
/// by row, at the start of the run
std::size_t marker_vertex(std::span<const double> positions);

}  // namespace capstan
