#pragma once
// A case that asks for an error: it climbs the ladder of resolutions until its estimated error is below.
#include "solver/case/parse.hpp"
#include "solver/output/finished_run.hpp"
#include "solver/run_directory/run_ending.hpp"

namespace capstan {

/// Computes one rung after the other, and publishes the last one as the run of the case. It ends without
/// meeting the error at the finest rung, or where finer ones are not expected to come nearer; then the finest
/// one with an answer is published, with a warning.
/// \param parsed       with a value
/// \param end_seconds  value of steady_seconds() at which the run is interrupted
RunEnding climb(const ParsedCase& parsed, const RunDirectory& directory, double end_seconds);

}  // namespace capstan
