#pragma once
// The axes of a phase diagram: two are drawn, each of the others is fixed at one value.
#include <nlohmann/json.hpp>

#include "runner/queries/phase_diagram.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// A diagram with its axes and fixed values, without cells. Appends the issues of the request to `issues`.
/// \param study  as find_study returns it
PhaseDiagram choose_axes(const nlohmann::ordered_json& study, const DiagramRequest& wanted, Issues& issues);

/// \param given  {"parameter", "values"}
PhaseAxis axis_from_json(const nlohmann::ordered_json& given);

}  // namespace capstan
