#include "runner/slurm/collect.hpp"

#include "runner/daemon/record_run.hpp"
#include "runner/daemon/submit_study.hpp"
#include "runner/recording/outcome.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

bool has_result(Database& database, const std::string& case_id) {
  return database.query("SELECT 1 FROM results WHERE case_id = ?", case_id).step();
}

void copy_run(const std::filesystem::path& from, const std::filesystem::path& to) {
  using std::filesystem::copy_options;
  std::filesystem::copy(
      from, to, copy_options::recursive | copy_options::overwrite_existing | copy_options::copy_symlinks);
}

/// False if the case is not queued, for example because it has failed.
bool record(const std::string& case_id, const RunDirectory& run, QueueWriter& writer) {
  const std::optional<Claim> claim = writer.queue.claim_case(case_id);
  if (!claim) return false;
  record_run(writer, *claim, run, outcome_of(ProcessEnd{}, run));
  return true;
}

}  // namespace

Collection collect(const Study& study, const std::filesystem::path& directory, const DataDirectory& data,
                   QueueWriter& writer, const Clock& clock) {
  Collection collection{submit_study(writer.database, clock, study).study_id};
  for (const Case& c : study.cases) {
    const std::string id = canonical(c).id;
    const RunDirectory exported(directory / "runs" / id);
    if (has_result(writer.database, id)) {
      ++collection.known;
    } else if (!exported.result()) {
      ++collection.unfinished;
    } else {
      copy_run(exported.path(), data.run(id).path());
      collection.recorded += record(id, data.run(id), writer) ? 1 : 0;
    }
  }
  return collection;
}

}  // namespace capstan
