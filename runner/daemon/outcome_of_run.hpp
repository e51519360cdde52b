#pragma once
// The outcome of a run that this daemon has supervised, or found when it started.
#include "runner/daemon/free_space.hpp"
#include "runner/daemon/run_supervision.hpp"
#include "runner/recording/outcome.hpp"

namespace capstan {

/// Like outcome_of, but a run whose files cannot be read at present counts as interrupted: its case is queued
/// again, and the files are read when it is started next. Throws std::filesystem::filesystem_error if the
/// daemon itself lacks descriptors or memory.
RunOutcome readable_outcome_of(const ProcessEnd& end, const RunDirectory& directory);

/// The outcome of a run whose process has ended. Precedence: result.json, then why the daemon stopped the
/// run, then the exit status of the process. A process that reported an error while the disk was full, or
/// after its directory was removed, counts as interrupted.
RunOutcome outcome_of_run(const RunSupervision& run, const RunDirectory& directory,
                          const FreeSpace& free_space);

}  // namespace capstan
