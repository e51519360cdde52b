#pragma once
// The five ways in which a run can end, with the same words in the worker's exit status, the daemon, the
// database and the API.
#include "solver/case/words.hpp"

namespace capstan {

enum class RunEnding {
  done,         ///< the run has a result
  failed,       ///< no result: the solver refused the case, or the run exceeded a limit
  diverged,     ///< numerical failure: the same run again would fail again
  interrupted,  ///< stopped before its end; the next attempt resumes from the checkpoint
  crashed,      ///< the process ended abnormally
};
/// The words of the database and the API.
template <>
inline constexpr auto kWords<RunEnding> = std::to_array<Word<RunEnding>>({{RunEnding::done, "done"},
                                                                          {RunEnding::failed, "failed"},
                                                                          {RunEnding::diverged, "diverged"},
                                                                          {RunEnding::interrupted,
                                                                           "interrupted"},
                                                                          {RunEnding::crashed, "crashed"}});

/// The exit status by which `capstan solve` reports the ending (schema/exit_codes.md).
int exit_code_of(RunEnding ending);
/// Inverse of exit_code_of; an unknown status is a crash.
RunEnding run_ending_of(int exit_code);

}  // namespace capstan
