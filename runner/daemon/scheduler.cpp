#include "runner/daemon/scheduler.hpp"

#include <algorithm>

#include "runner/daemon/earlier_run.hpp"
#include "runner/daemon/outcome_of_run.hpp"
#include "runner/daemon/record_run.hpp"
#include "runner/daemon/remove_deleted_cases.hpp"
#include "runner/store/fail_point.hpp"

namespace capstan {
namespace {

/// Starts in one tick, and histories read in one tick. On a cluster thousands of cases may be started or
/// running; clients wait for the writer's mutex meanwhile.
constexpr int kMaxStarts = 500;
constexpr std::size_t kMaxHistories = 64;

}  // namespace

Scheduler::Scheduler(QueueWriter& writer, Executor& executor, const Clock& clock, const DataDirectory& data,
                     const FreeSpace& free_space, RunLimits limits)
    : writer_(writer),
      executor_(executor),
      clock_(clock),
      data_(data),
      free_space_(free_space),
      limits_(limits) {}

/// Handles the processes before it writes to the database, so that a run can be stopped even if the disk is
/// full.
void Scheduler::tick() {
  std::exception_ptr error = read_cancellations();
  if (const auto later = for_each_run([this](Run& run) { supervise(run.supervision); })) error = later;
  writer_.expect_sound();
  if (const auto later = for_each_run([this](Run& run) { record(run); })) error = later;
  std::erase_if(runs_, [](const Run& run) { return run.is_recorded; });
  writer_.queue.give_back_expired([this](const Claim& claim) { return has_run(claim); });
  remove_deleted_cases(writer_.database, data_);
  if (!draining_) start_runs();
  if (error) std::rethrow_exception(error);
}

bool Scheduler::has_ended() const {
  return std::all_of(runs_.begin(), runs_.end(),
                     [](const Run& run) { return run.supervision.end().has_value(); });
}

/// Returns the last of the errors, or nullptr.
std::exception_ptr Scheduler::for_each_run(const std::function<void(Run&)>& action) {
  std::exception_ptr error;
  for (Run& run : runs_) try {
      action(run);
    } catch (...) {
      error = std::current_exception();
    }
  return error;
}

void Scheduler::supervise(RunSupervision& run) {
  if (run.end()) return;
  run.check_progress();
  run.enforce_limits();
  if (draining_ || to_be_cancelled_.contains(run.claim().token)) run.ask_to_stop();
  run.poll();
}

void Scheduler::drain() {
  draining_ = true;
  if (executor_.outlives_daemon()) runs_.clear();
}

/// With one query for all runs, as there may be thousands. Returns the error, or nullptr: the runs are
/// supervised in any case.
std::exception_ptr Scheduler::read_cancellations() try {
  if (!runs_.empty()) to_be_cancelled_ = writer_.queue.to_be_cancelled();
  return nullptr;
} catch (...) {
  return std::current_exception();
}

/// With many runs, each waits for its turn.
void Scheduler::record_news(Run& run) {
  if (++run.ticks_since_read * kMaxHistories < runs_.size()) return;
  run.ticks_since_read = 0;
  const std::string& case_id = run.supervision.claim().case_id;
  const HistoryTail::News news = run.history.read_new();
  if (news.begin_anew)
    store_history_file(writer_.database, case_id, {news.records});
  else
    store_history(writer_.database, case_id, news.first, news.records);
}

void Scheduler::record(Run& run) {
  const Claim& claim = run.supervision.claim();
  record_news(run);
  const std::optional<ProcessEnd>& end = run.supervision.end();
  if (!end) return run.supervision.keep_lease(writer_.queue);
  const RunDirectory directory = data_.run(claim.case_id);
  if (end->how == ProcessEnd::How::not_begun)
    writer_.queue.put_back(claim, describe(*end));
  else
    record_run(writer_, claim, directory, outcome_of_run(run.supervision, directory, free_space_));
  run.is_recorded = true;
}

bool Scheduler::has_run(const Claim& claim) const {
  return std::any_of(runs_.begin(), runs_.end(),
                     [&](const Run& run) { return run.supervision.claim().token == claim.token; });
}

void Scheduler::start_runs() {
  const std::size_t waiting = writer_.queue.waiting();
  for (int starts = 0; starts < kMaxStarts && executor_.has_room(runs_.size(), waiting); ++starts)
    if (!start_next()) return;
}

/// Starts a run of the next case; false if no case can be started or the disk is almost full. If the run
/// directory already holds a result, that is recorded and no process is started: the database lost the
/// record, because it was replaced by a backup or because a power failure undid its last commit. If the
/// environment prevents the start (a full disk, no process can be created), the case goes back into the
/// queue.
bool Scheduler::start_next() {
  if (!free_space_.shortage().empty()) return false;
  std::optional<Claim> claim = writer_.queue.claim();
  if (!claim) return false;
  const RunDirectory directory = data_.run(claim->case_id);
  bool is_complete = false;
  try {
    is_complete = directory.result().has_value();
    if (is_complete)
      record_run(writer_, *claim, directory, outcome_of(ProcessEnd{}, directory));
    else
      start_process(*claim, directory);
  } catch (const std::exception& error) {
    writer_.queue.put_back(*claim, std::string("could not be started: ") + error.what());
    throw;
  }
  if (!is_complete) add_run(*claim);
  return true;
}

void Scheduler::start_process(Claim& claim, const RunDirectory& directory) {
  directory.prepare(claim.document);
  if (directory.is_worthless())
    if (const auto earlier = earlier_run(writer_.database, claim.case_id))
      directory.go_on_from(data_.run(*earlier));
  directory.begin_attempt(claim.token);
  fail_point("prepared");
  claim.handle = executor_.start(claim, directory);
  fail_point("spawned");
}

void Scheduler::supervise_run(const Claim& claim) {
  runs_.push_back({RunSupervision(claim, executor_, clock_, limits_, writer_.queue.heartbeat()),
                   HistoryTail(data_.run(claim.case_id).history_file())});
}

void Scheduler::add_run(const Claim& claim) {
  supervise_run(claim);
  writer_.queue.started(claim, claim.handle);
  fail_point("started");
}

}  // namespace capstan
