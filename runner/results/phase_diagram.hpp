#pragma once
// The answer of a study at a glance: the motion over two of its axes.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace capstan {

struct PhaseAxis {
  std::string parameter;
  std::vector<nlohmann::ordered_json> values;  ///< ascending, if they are numbers
};

/// What the cases at one point of the diagram say. Cases that differ along a third axis share a point.
struct PhaseCell {
  std::string motion;  ///< the motion of all its cases; "mixed" if they differ, "" as long as there is none
  std::string state;   ///< the state of all its cases; "mixed" if they differ
  std::vector<std::string> cases;  ///< ids
};

struct PhaseDiagram {
  PhaseAxis x;
  PhaseAxis y;  ///< without parameter and with one value, null, if the study has one axis
  std::vector<std::vector<PhaseCell>> rows;  ///< one a y value, one cell an x value
};

/// \param study  as find_study gives it  \param cases  as find_cases gives them
/// \param x, y   axes of the study; by default the first two
/// Nothing if the study has no axes, or not those.
std::optional<PhaseDiagram> phase_diagram(const nlohmann::ordered_json& study,
                                          const nlohmann::ordered_json& cases, const std::string& x = "",
                                          const std::string& y = "");

nlohmann::ordered_json to_json(const PhaseDiagram& diagram);
PhaseDiagram phase_diagram_from_json(const nlohmann::ordered_json& json);

/// A grid of TB, TT, TR, …  with a legend; y upwards, as in the paper.
/// \param coloured  with the escape codes of a terminal
std::string render(const PhaseDiagram& diagram, bool coloured);

}  // namespace capstan
