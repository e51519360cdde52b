#pragma once
// What a user can change when a run has failed.
#include <string>

#include "solver/case/case.hpp"
#include "solver/mesh/surface_quality.hpp"

namespace capstan {

/// Whether the surface is folded or has triangles that have collapsed: its forces and flow are then
/// meaningless.
bool is_lost(const SurfaceQuality& surface);

/// Sentences that name likely causes of a failure and what to change in the case; empty if there is none.
/// \param surface    at the time of the failure
/// \param of_motion  whether the positions of the membrane became wrong: then the time step may be too long
std::string remedy(const Case& c, const SurfaceQuality& surface, bool of_motion);

/// "the volume has drifted by 11 %", or a sentence for a drift that is huge or not finite.
/// \param drift V/V(0) - 1
std::string volume_drift_in_words(double drift);

}  // namespace capstan
