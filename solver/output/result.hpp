#pragma once
// The answer of a run: result.json (schema/run_directory.md).
#include <nlohmann/json.hpp>

#include "solver/case/case.hpp"
#include "solver/case/choice.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

/// The case with what was chosen for it; class, evidence, final state, cost and trust record.
/// \param seconds wall time of the run, over all processes that worked on it
nlohmann::ordered_json result_json(const Case& c, const Choices& choices, const Simulation& simulation,
                                   const Outcome& outcome, double seconds);

}  // namespace capstan
