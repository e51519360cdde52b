#pragma once
// The capsule's initial, stress-free shapes. Each maps points of the unit sphere to a surface of revolution
// about y, which initial_positions then rotates.
#include "solver/case/case.hpp"
#include "solver/mesh/icosphere.hpp"

namespace capstan {

/// Spheroid, paper eq. 45 with R = 1: semi-axis `aspect` along y and 1 across.
/// \param directions  3 x #V, unit
Points spheroid(const Points& directions, double aspect);

/// Red blood cell at rest after Fung, paper eq. 46; theta is the angle between direction and y axis. Edges
/// along a meridian are at least 0.54 times as long as those around the axis; the minimum is at the rim.
Points biconcave(const Points& directions);

/// 3 x #V: positions at the start of a run. The triangulated surface encloses the volume 4 pi / 3; its major
/// axis lies in the plane of shear (x, y) at an angle of +pi/4 with x.
Points initial_positions(const Case& c, const Icosphere& sphere);

}  // namespace capstan
