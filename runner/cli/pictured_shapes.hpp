#pragma once
// Profiles and trajectories of cases, from their recorded shapes.
#include "runner/cli/pictured_cases.hpp"
#include "runner/render/shape_picture.hpp"

namespace capstan {

/// A panel for each time, with the profiles of all cases. Throws std::invalid_argument where a case has
/// recorded no shape at a time.
/// \param times  kt; none: one panel with the last shape of each case
std::vector<ProfilePanel> profile_panels(Client& client, const std::vector<PicturedCase>& cases,
                                         const std::vector<double>& times);

/// The trajectory of the marker of each case, through all recorded shapes.
std::vector<Trajectory> trajectories(Client& client, const std::vector<PicturedCase>& cases);

}  // namespace capstan
