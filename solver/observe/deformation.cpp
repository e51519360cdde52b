#include "solver/observe/deformation.hpp"

#include <cmath>
#include <numbers>

#include "solver/mesh/geometry.hpp"

namespace capstan {

// Along an axis of half length h an ellipsoid of volume V has the second moment V h^2 / 5. One axis stays
// along z, so the squares of the other two are the eigenvalues of the x-y block of M = 5/V second moments,
// which has the form
//   mean * 1 + difference * [cos 2 theta, sin 2 theta; sin 2 theta, -cos 2 theta].
InertiaEllipse inertia_ellipse(const Points& positions, const Faces& faces) {
  const Eigen::Matrix3d M = second_moments(positions, faces) * 5 / volume(positions, faces);
  const double mean = (M(0, 0) + M(1, 1)) / 2;
  const double along_x = (M(0, 0) - M(1, 1)) / 2, along_diagonal = M(0, 1);
  const double difference = std::hypot(along_x, along_diagonal);
  double theta = std::atan2(along_diagonal, along_x) / 2;
  if (theta <= -std::numbers::pi / 2) theta = std::numbers::pi / 2;  // atan2(-0, negative)
  return {centroid(positions, faces), std::sqrt(mean + difference), std::sqrt(mean - difference), theta};
}

Deformation deformation(const InertiaEllipse& ellipse) {
  return {(ellipse.major - ellipse.minor) / (ellipse.major + ellipse.minor), ellipse.theta};
}

}  // namespace capstan
