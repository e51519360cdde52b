#include "runner/daemon/record_run.hpp"

#include "runner/daemon/case_rows.hpp"
#include "runner/daemon/extend_search.hpp"
#include "runner/recording/history.hpp"
#include "runner/recording/result.hpp"
#include "runner/store/fail_point.hpp"
#include "solver/case/content_id.hpp"
#include "solver/run_directory/checkpoint_files.hpp"

namespace capstan {
namespace {

/// A case that is done keeps its newest checkpoint: a case with a later end goes on from it. A diverged one
/// keeps none: it would diverge again. If a file cannot be removed, only disk space is lost.
void remove_spare_checkpoints(const RunDirectory& directory, const std::string& steps_id, RunEnding ending) {
  if (ending == RunEnding::done) keep_newest_checkpoint(directory, steps_id, kNumericsVersion);
  if (ending != RunEnding::diverged) return;
  std::error_code ignored;
  for (const auto& checkpoint : directory.checkpoint_paths()) std::filesystem::remove(checkpoint, ignored);
}

}  // namespace

void record_run(QueueWriter& writer, const Claim& claim, const RunDirectory& directory,
                const RunOutcome& outcome) {
  Transaction transaction(writer.database);
  if (!writer.queue.end(claim, outcome.ending, outcome.message)) return;
  store_history_file(writer.database, claim.case_id, read_history(directory.history_file()));
  if (outcome.result) store_result(writer.database, claim.case_id, *outcome.result);
  extend_searches_with(writer.database, claim.case_id);
  const std::string steps_id = stored_steps_id(writer.database, claim.case_id);
  fail_point("recording");
  transaction.commit();
  fail_point("recorded");
  remove_spare_checkpoints(directory, steps_id, outcome.ending);
}

}  // namespace capstan
