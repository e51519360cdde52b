#include "runner/daemon/outcome_of_run.hpp"

#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

/// An interruption, if the process reported an error because its directory was removed or the disk was full;
/// else nothing.
std::optional<RunOutcome> interruption_by_environment(const ProcessEnd& end, const RunDirectory& directory,
                                                      const FreeSpace& free_space) {
  if (end.how != ProcessEnd::How::exited || end.number != kExitError) return std::nullopt;
  if (!std::filesystem::exists(directory.path()))
    return RunOutcome{RunEnding::interrupted, "its directory was removed"};
  if (!free_space.shortage().empty()) return RunOutcome{RunEnding::interrupted, "the disk was full"};
  return std::nullopt;
}

}  // namespace

RunOutcome readable_outcome_of(const ProcessEnd& end, const RunDirectory& directory) try {
  return outcome_of(end, directory);
} catch (const std::filesystem::filesystem_error& error) {
  if (is_shortage(error)) throw;
  return {RunEnding::interrupted, error.what()};
}

RunOutcome outcome_of_run(const RunSupervision& run, const RunDirectory& directory,
                          const FreeSpace& free_space) {
  const ProcessEnd& end = run.end().value();
  RunOutcome outcome = readable_outcome_of(end, directory);
  if (outcome.result) return outcome;
  if (auto interruption = interruption_by_environment(end, directory, free_space)) return *interruption;
  if (!run.exceeded_limit().empty()) return {RunEnding::failed, run.exceeded_limit()};
  if (run.is_killed() && run.has_stalled())
    return {RunEnding::crashed, "it stood still until its lease ran out, and was killed"};
  if (run.is_killed())
    return {RunEnding::interrupted, "it did not stop when it was asked to, and was killed"};
  if (run.is_asked_to_stop() && outcome.ending == RunEnding::crashed)
    return {RunEnding::interrupted, "it was asked to stop, and ended without a checkpoint: " + describe(end)};
  return outcome;
}

}  // namespace capstan
