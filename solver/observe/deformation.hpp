#pragma once
// Deformation and inclination of the capsule in the plane of shear.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// Section by the plane of shear of the ellipsoid that has the capsule's moments of inertia (paper eq. 44).
struct InertiaEllipse {
  Vec3 centre;          ///< / a
  double major, minor;  ///< half axes L >= l, / a
  double theta;  ///< angle of the major axis with x, radians, in (-pi/2, pi/2]; rounding noise where L = l
};
/// \param positions 3 x #V   \param faces 3 x #F, a closed surface
InertiaEllipse inertia_ellipse(const Points& positions, const Faces& faces);

struct Deformation {
  double D_xy;   ///< Taylor deformation (L - l)/(L + l), paper eq. 5
  double theta;  ///< as in InertiaEllipse
};
Deformation deformation(const InertiaEllipse& ellipse);

}  // namespace capstan
