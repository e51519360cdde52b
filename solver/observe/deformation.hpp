#pragma once
// How elongated the capsule is in the plane of shear, and which way it lies.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// The ellipsoid that has the capsule's moments of inertia (paper eq. 44), cut by the plane of shear.
struct InertiaEllipse {
  Vec3 centre;
  double major, minor;  ///< half axes L >= l
  double theta;         ///< angle of the major axis with x, radians, in (-pi/2, pi/2]; noise where L = l
};
InertiaEllipse inertia_ellipse(const Points& positions, const Faces& faces);

struct Deformation {
  double D_xy;   ///< Taylor's (L - l)/(L + l), paper eq. 5
  double theta;  ///< as in InertiaEllipse
};
Deformation deformation(const InertiaEllipse& ellipse);

}  // namespace capstan
