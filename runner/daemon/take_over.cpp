#include "runner/daemon/take_over.hpp"

#include "runner/daemon/case_rows.hpp"
#include "runner/daemon/extend_search.hpp"
#include "runner/daemon/outcome_of_run.hpp"
#include "runner/daemon/points.hpp"
#include "runner/daemon/record_run.hpp"
#include "runner/daemon/replacement.hpp"
#include "runner/store/orphaned_runs.hpp"

namespace capstan {
namespace {

void end_run(QueueWriter& writer, Executor& executor, const Claim& claim, const RunDirectory& directory) {
  executor.cancel(claim.handle, StopBy::kill);
  executor.wait_until_free(directory);
  directory.remove_partial_files();
  record_run(writer, claim, directory, readable_outcome_of(ProcessEnd{}, directory));
}

}  // namespace

std::vector<Claim> take_over(QueueWriter& writer, Executor& executor, const DataDirectory& data) {
  std::vector<Claim> adopted;
  for (const Claim& claim : writer.queue.running())
    if (const RunDirectory directory = data.run(claim.case_id); executor.adopt(claim, directory))
      adopted.push_back(claim);
    else
      end_run(writer, executor, claim, directory);
  derive_old_points(writer.database);
  estimate_missing_costs(writer.database);
  replace_outdated(writer.database);
  extend_all_searches(writer.database);
  for (const RunDirectory& orphan : orphaned_runs(data.runs(), writer.database))
    if (orphan.is_worthless()) std::filesystem::remove_all(orphan.path());
  return adopted;
}

}  // namespace capstan
