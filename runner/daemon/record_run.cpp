#include "runner/daemon/record_run.hpp"

#include "runner/daemon/extend_search.hpp"
#include "runner/recording/history.hpp"
#include "runner/recording/result.hpp"
#include "runner/store/fail_point.hpp"
#include "solver/case/content_id.hpp"
#include "solver/run_directory/checkpoint_files.hpp"

namespace capstan {
namespace {

/// A case that is done keeps its newest checkpoint, from which it could be continued. A diverged one keeps
/// none: it would diverge again. If a file cannot be removed, only disk space is lost.
void remove_spare_checkpoints(const std::string& case_id, const RunDirectory& directory, RunEnding ending) {
  if (ending != RunEnding::done && ending != RunEnding::diverged) return;
  const auto [newest, other] = checkpoint_files(directory, case_id, kNumericsVersion);
  std::error_code ignored;
  std::filesystem::remove(other.path, ignored);
  if (ending == RunEnding::diverged) std::filesystem::remove(newest.path, ignored);
}

}  // namespace

void record_run(QueueWriter& writer, const Claim& claim, const RunDirectory& directory,
                const RunOutcome& outcome) {
  Transaction transaction(writer.database);
  if (!writer.queue.end(claim, outcome.ending, outcome.message)) return;
  store_history_file(writer.database, claim.case_id, read_history(directory.history_file()));
  if (outcome.result) store_result(writer.database, claim.case_id, *outcome.result);
  extend_searches_with(writer.database, claim.case_id);
  fail_point("recording");
  transaction.commit();
  fail_point("recorded");
  remove_spare_checkpoints(claim.case_id, directory, outcome.ending);
}

}  // namespace capstan
