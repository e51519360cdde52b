#pragma once
// The result of a run: result.json (schema/run_directory.md).
#include <nlohmann/json.hpp>

#include "solver/case/case.hpp"
#include "solver/case/choice.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

/// Contains the case and the chosen settings, the motion and its evidence, the last record, the cost, and
/// measures of accuracy.
/// \param seconds wall time of the run, summed over all its processes
nlohmann::ordered_json result_json(const Case& c, const Choices& choices, const Simulation& simulation,
                                   const Outcome& outcome, double seconds);

}  // namespace capstan
