#pragma once
// One run of a case at one resolution, in a run directory, with its progress on standard error.
#include <optional>

#include "solver/case/choice.hpp"
#include "solver/output/finished_run.hpp"
#include "solver/run_directory/run_ending.hpp"

namespace capstan {

/// Computes a run, from its newest checkpoint if there is one. Writes all files but result.json. Nothing if
/// it was interrupted. \param end_seconds  value of steady_seconds() at which the run is interrupted
std::optional<FinishedRun> compute_run(const Case& c, const Choices& choices, const RunDirectory& directory,
                                       double end_seconds);

/// Computes a case at another rung of the ladder, in a directory of its own, which holds the same files as
/// that of any finished run. Meanwhile the file with the history of the case is a link to the one of the
/// rung.
std::optional<FinishedRun> compute_rung(const Case& rung, const RunDirectory& of_case, double end_seconds);

/// Adds the computing time of another run of the same case.
void add_seconds(nlohmann::ordered_json& result, const nlohmann::ordered_json& other);

/// Writes result.json, which marks the case as complete. Returns how the run ended.
RunEnding write_result(const RunDirectory& directory, const FinishedRun& run);

}  // namespace capstan
