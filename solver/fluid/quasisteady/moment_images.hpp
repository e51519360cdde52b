#pragma once
// Images of moments and scalars in ghost cells (grid/ghosts.hpp).
#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/grid/ghosts.hpp"

namespace capstan {

/// Behind a wall at rest (half-way bounce-back) the density is even and the momentum is odd. Mirror and
/// half-turn reverse the components of vectors normal to the plane or the axis.
inline constexpr ImageComponent kMomentsBehindWall[] = {{kRho, 1}, {kGx, -1}, {kGy, -1}, {kGz, -1}};
inline constexpr ImageComponent kMirroredMoments[] = {{kRho, 1}, {kGx, 1}, {kGy, 1}, {kGz, -1}};
inline constexpr ImageComponent kTurnedMoments[] = {{kRho, 1}, {kGx, -1}, {kGy, -1}, {kGz, 1}};
inline constexpr Images kMomentImages = {kMomentsBehindWall, kMirroredMoments, kTurnedMoments};

/// A scalar is even everywhere.
inline constexpr ImageComponent kEven[] = {{0, 1}};
inline constexpr Images kScalarImages = {kEven, kEven, kEven};

}  // namespace capstan
