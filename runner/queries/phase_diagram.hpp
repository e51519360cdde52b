#pragma once
// Phase diagram of a study: the motion over two of its axes.
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

/// The points at one place of the diagram: one, or more if an older version stored the study.
struct PhaseCell {
  std::string motion;  ///< common motion of its cases; "mixed" if they differ, "" before there is one
  std::string state;   ///< common state of its cases; "mixed" if they differ
  std::vector<std::string> cases;  ///< ids
  bool is_confirmed = true;        ///< the motion of all of them
};

struct PhaseDiagram {
  PhaseAxis x;
  PhaseAxis y;  ///< for a study with one axis: no parameter, and null as its only value
  std::map<std::string, nlohmann::json> at;  ///< values of the other axes
  std::vector<std::vector<PhaseCell>> rows;  ///< one row for each y value, one cell for each x value
};

/// The diagram that a client asks for.
struct DiagramRequest {
  std::string x, y;             ///< drawn axes; "": the first that has more than one value
  std::vector<std::string> at;  ///< "E_b=0.015": value of an axis that is not drawn
};

struct ParsedDiagram {
  std::optional<PhaseDiagram> value;  ///< present if there are no issues
  Issues issues;                      ///< at "x", "y" or "at", with the possible values
};

/// \param study  as find_study returns it, with one axis or more
ParsedDiagram phase_diagram(const nlohmann::ordered_json& study, const std::vector<PointMotion>& points,
                            const DiagramRequest& wanted = {});

nlohmann::ordered_json to_json(const PhaseDiagram& diagram);
PhaseDiagram phase_diagram_from_json(const nlohmann::ordered_json& json);

}  // namespace capstan
