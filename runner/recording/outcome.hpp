#pragma once
// The outcome of a run, from its exit status and its run directory alone.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "runner/recording/process_end.hpp"
#include "solver/run_directory/run_directory.hpp"
#include "solver/run_directory/run_ending.hpp"

namespace capstan {

struct RunOutcome {
  RunEnding ending;
  std::string message;                                ///< reason of the ending; may be empty
  std::optional<nlohmann::ordered_json> result = {};  ///< result.json
};

/// A complete result.json decides, however the process ended after writing it. Without one the exit status
/// decides (schema/exit_codes.md). Throws std::filesystem::filesystem_error if result.json cannot be read.
RunOutcome outcome_of(const ProcessEnd& end, const RunDirectory& directory);

}  // namespace capstan
