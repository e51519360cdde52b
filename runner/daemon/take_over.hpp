#pragma once
// What a daemon does when it starts: it ends what an earlier daemon left running, and brings its records up
// to date.
#include <vector>

#include "runner/daemon/executor.hpp"
#include "runner/daemon/queue_writer.hpp"
#include "runner/store/data_directory.hpp"

namespace capstan {

/// Ends the runs of an earlier daemon that the executor cannot adopt; those that are complete are recorded,
/// the others are queued again. Returns the claims of those that go on. Also converts cases and studies that
/// an earlier program stored to the present form, and removes run directories that belong to no case and hold
/// neither a result nor a checkpoint.
std::vector<Claim> take_over(QueueWriter& writer, Executor& executor, const DataDirectory& data);

}  // namespace capstan
