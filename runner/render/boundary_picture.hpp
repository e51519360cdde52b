#pragma once
// The boundary as a part of the picture of a phase diagram, in gnuplot's language.
#include <nlohmann/json.hpp>
#include <string>

#include "runner/queries/phase_diagram.hpp"

namespace capstan {

struct BoundaryDrawing {
  std::string blocks;  ///< blocks of data
  std::string behind;  ///< elements of the plot that lie behind the marks: the bands
  std::string before;  ///< elements that lie before them: the curves with their limits
};

/// Each curve with its band, and bars between the limits of each value. Empty unless the diagram's axes are
/// those of the boundary.
/// \param boundary  as find_boundary returns it, or null
BoundaryDrawing boundary_drawing(const PhaseDiagram& diagram, const nlohmann::ordered_json& boundary);

}  // namespace capstan
