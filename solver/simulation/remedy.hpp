#pragma once
// What a user can change when a run has failed.
#include <string>

#include "solver/case/case.hpp"
#include "solver/mesh/surface_quality.hpp"

namespace capstan {

/// Faces have folded onto each other, or triangles have collapsed: flow and forces mean nothing any more.
bool is_lost(const SurfaceQuality& surface);

/// Sentences on what made a run fail, as far as the case and the surface's last shape tell, each with what to
/// change; empty when they tell nothing. \param of_motion the membrane's motion went wrong, so that the time
/// step may be too long
std::string remedy(const Case& c, const SurfaceQuality& surface, bool of_motion);

/// "the volume has drifted by 11 %", also where the number is beyond all sense or none.
/// \param drift V/V(0) - 1
std::string volume_drift_in_words(double drift);

}  // namespace capstan
