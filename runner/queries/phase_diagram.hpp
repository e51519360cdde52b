#pragma once
// The answer of a study at a glance: the motion over two of its axes.
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runner/queries/queries.hpp"

namespace capstan {

struct PhaseAxis {
  std::string parameter;
  std::vector<nlohmann::json> values;  ///< as asked for; ascending, if they are numbers
};

/// What the points at one place of the diagram say: one point, or more in a study of an earlier program.
struct PhaseCell {
  std::string motion;  ///< the motion of all its cases; "mixed" if they differ, "" as long as there is none
  std::string state;   ///< the state of all its cases; "mixed" if they differ
  std::vector<std::string> cases;  ///< ids
};

struct PhaseDiagram {
  PhaseAxis x;
  PhaseAxis y;  ///< without parameter and with one value, null, if the study has one axis
  std::map<std::string, nlohmann::json> at;  ///< where the other axes are fixed
  std::vector<std::vector<PhaseCell>> rows;  ///< one a y value, one cell an x value
};

/// Which diagram of a study is wanted.
struct DiagramRequest {
  std::string x, y;             ///< axes; by default the first two that have more than one value
  std::vector<std::string> at;  ///< "E_b=0.015": the value at which another axis is fixed
};

struct ParsedDiagram {
  std::optional<PhaseDiagram> value;  ///< engaged when issues is empty
  Issues issues;                      ///< at "x", "y" or "at", with the possible values
};

/// \param study  as find_study gives it, with one axis or more
ParsedDiagram phase_diagram(const nlohmann::ordered_json& study, const std::vector<PointMotion>& points,
                            const DiagramRequest& wanted = {});

nlohmann::ordered_json to_json(const PhaseDiagram& diagram);
PhaseDiagram phase_diagram_from_json(const nlohmann::ordered_json& json);

}  // namespace capstan
