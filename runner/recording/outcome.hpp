#pragma once
// What the end of a run means, from its exit status and its run directory alone.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "runner/recording/process_end.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

struct RunOutcome {
  enum class Kind { done, failed, diverged, interrupted, crashed };
  Kind kind;
  std::string message;                           ///< why, where that needs words
  std::optional<nlohmann::ordered_json> result;  ///< result.json
};

/// A result.json says that the run is complete, however its process ended after that. Without one the exit
/// status counts (schema/exit_codes.md).
RunOutcome outcome_of(const ProcessEnd& end, const RunDirectory& directory);

}  // namespace capstan
