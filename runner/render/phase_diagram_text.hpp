#pragma once
#include <string>

#include "runner/queries/phase_diagram.hpp"

namespace capstan {

/// The phase diagram for a terminal: a grid of TB (tumbling), TT (tank-treading), TR (transition) and other
/// marks, with a legend. Columns with few points are left out and counted. The y axis points upwards, as in
/// the paper. \param coloured  with escape codes
std::string phase_diagram_text(const PhaseDiagram& diagram, bool coloured);

}  // namespace capstan
