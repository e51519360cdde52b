#pragma once
#include <array>
#include <string>
#include <vector>

#include "runner/queries/phase_diagram.hpp"
#include "runner/render/gnuplot.hpp"

namespace capstan {

/// Points of the boundary that others have published, with their source in the key.
struct PublishedBoundary {
  std::string title;
  std::vector<std::array<double, 2>> points;  ///< x, y
};

/// gnuplot's script for a phase diagram: a mark for each point, with a shape and a colour for each motion
/// (the colours can be told apart by colour-blind readers, and in grey); filled where the motion is
/// confirmed. A boundary is drawn with its band.
/// \param boundary   as find_boundary returns it, or null
/// \param published  drawn as black marks, where both axes are of numbers
std::string phase_diagram_script(const PhaseDiagram& diagram, const nlohmann::ordered_json& boundary,
                                 const std::vector<PublishedBoundary>& published,
                                 const PictureFormat& format);

}  // namespace capstan
