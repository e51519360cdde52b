#pragma once
// All runs of a case: its companion and its own; or a climb of the ladder to the error asked for.
#include "solver/case/parse.hpp"
#include "solver/run_directory/run_directory.hpp"
#include "solver/run_directory/run_ending.hpp"

namespace capstan {

/// Computes what is missing in the directory, and writes result.json as the last file.
/// \param parsed       with a value
/// \param end_seconds  value of steady_seconds() at which the run is interrupted
RunEnding run_case(const ParsedCase& parsed, const RunDirectory& directory, double end_seconds);

}  // namespace capstan
