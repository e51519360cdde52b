#pragma once
#include <string>

#include "runner/queries/phase_diagram.hpp"
#include "runner/render/gnuplot.hpp"

namespace capstan {

/// gnuplot's script for a phase diagram: a mark for each point, with a shape and a colour for each motion
/// (the colours can be told apart by colour-blind readers, and in grey); filled where the motion is
/// confirmed. A boundary is drawn with its band.
/// \param boundary  as find_boundary returns it, or null
std::string phase_diagram_script(const PhaseDiagram& diagram, const nlohmann::ordered_json& boundary,
                                 const PictureFormat& format);

}  // namespace capstan
