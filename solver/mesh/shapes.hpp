#pragma once
// The capsule's initial, stress-free shapes. All are mapped from the directions of the unit sphere; the axis
// of revolution is y before they are inclined.
#include "solver/case/case.hpp"
#include "solver/mesh/icosphere.hpp"

namespace capstan {

/// Paper eq. 45 with R = 1: the axis of revolution has length `aspect`, the equator radius 1.
Points spheroid(const Points& directions, double aspect);

/// Red blood cell at rest after Fung, paper eq. 46, with theta the angle of the direction from the y axis.
/// Edges along the meridian shrink to no less than 0.54 of those around the axis, at the rim.
Points biconcave(const Points& directions);

/// Positions at the start of a run: the triangulated surface encloses the volume 4 pi / 3, and its major axis
/// lies in the plane of shear (x, y) at an angle of +pi/4 with x.
Points initial_positions(const Case& c, const Icosphere& sphere);

}  // namespace capstan
