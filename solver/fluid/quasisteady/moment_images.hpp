#pragma once
// Images of moments and stresses in ghost cells (grid/ghosts.hpp).
#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/grid/ghosts.hpp"

namespace capstan {

/// Behind a wall at rest (half-way bounce-back) the density is even and the momentum is odd. Mirror and
/// half-turn reverse the components of vectors normal to the plane or the axis.
inline constexpr ImageComponent kMomentsBehindWall[] = {{kRho, 1}, {kGx, -1}, {kGy, -1}, {kGz, -1}};
inline constexpr ImageComponent kMirroredMoments[] = {{kRho, 1}, {kGx, 1}, {kGy, 1}, {kGz, -1}};
inline constexpr ImageComponent kTurnedMoments[] = {{kRho, 1}, {kGx, -1}, {kGy, -1}, {kGz, 1}};
inline constexpr Images kMomentImages = {kMomentsBehindWall, kMirroredMoments, kTurnedMoments};

/// Stresses are even behind a wall; mirror and half-turn reverse P_xz and P_yz.
inline constexpr ImageComponent kStressesBehindWall[] = {{kXX, 1}, {kYY, 1}, {kXY, 1}, {kXZ, 1}, {kYZ, 1}};
inline constexpr ImageComponent kReflectedStresses[] = {{kXX, 1}, {kYY, 1}, {kXY, 1}, {kXZ, -1}, {kYZ, -1}};
inline constexpr Images kStressImages = {kStressesBehindWall, kReflectedStresses, kReflectedStresses};

}  // namespace capstan
