#pragma once
// The five ways in which a run can end, with the same words in the worker's exit status, the daemon, the
// database and the API.
#include <array>
#include <optional>
#include <string_view>

namespace capstan {

enum class RunEnding {
  done,         ///< the run has a result
  failed,       ///< no result: the solver refused the case, or the run exceeded a limit
  diverged,     ///< numerical failure: the same run again would fail again
  interrupted,  ///< stopped before its end; the next attempt resumes from the checkpoint
  crashed,      ///< the process ended abnormally
};

inline constexpr std::array kRunEndings = {RunEnding::done, RunEnding::failed, RunEnding::diverged,
                                           RunEnding::interrupted, RunEnding::crashed};

/// The word of the database and the API, for example "done".
std::string_view to_string(RunEnding ending);
/// Nothing if `word` is none of the five words.
std::optional<RunEnding> parse_run_ending(std::string_view word);

/// The exit status by which `capstan solve` reports the ending (schema/exit_codes.md).
int exit_code_of(RunEnding ending);
/// Inverse of exit_code_of; an unknown status is a crash.
RunEnding run_ending_of(int exit_code);

}  // namespace capstan
