#pragma once
// The outcome of a run that this daemon has supervised, or found when it started.
#include "runner/daemon/free_space.hpp"
#include "runner/daemon/run_supervision.hpp"
#include "runner/recording/outcome.hpp"

namespace capstan {

/// As outcome_of, but where the files of the run cannot be read now the run counts as interrupted: its case
/// waits in the queue, and the files are read at its next start. Throws std::filesystem::filesystem_error if
/// the daemon itself lacks descriptors or memory.
RunOutcome readable_outcome_of(const ProcessEnd& end, const RunDirectory& directory);

/// The outcome of a run whose process has ended. Precedence: result.json, then why the daemon stopped the
/// run, then the exit status of the process. An error exit is an interruption where the disk was full or the
/// directory was removed.
RunOutcome outcome_of_run(const RunSupervision& run, const RunDirectory& directory,
                          const FreeSpace& free_space);

}  // namespace capstan
