#pragma once
// Recording what a run has left: its ending, its history and its result.
#include "runner/daemon/queue_writer.hpp"
#include "runner/recording/outcome.hpp"

namespace capstan {

/// Records everything in one transaction, with the points that searches for a boundary ask for next, then
/// removes the checkpoints that are not needed any more. Records nothing if the claim is no longer valid. The
/// caller holds the writer's mutex.
void record_run(QueueWriter& writer, const Claim& claim, const RunDirectory& directory,
                const RunOutcome& outcome);

}  // namespace capstan
