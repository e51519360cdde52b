#include "runner/service/service.hpp"

#include <algorithm>

#include "runner/results/result.hpp"

namespace capstan {

Service::Service(const DataDirectory& data, Executor& executor, const Clock& clock, int cores)
    : data_(data),
      executor_(executor),
      clock_(clock),
      cores_(static_cast<std::size_t>(cores)),
      database_(data.database(), Database::Access::write),
      queue_(database_, clock) {
  take_over();
}

void Service::take_over() {
  for (const Claim& claim : queue_.running()) {
    executor_.cancel(claim.handle, Stop::kill);
    record(claim, outcome_of(RunEnd{}, data_.run(claim.case_id)));
  }
}

Submission Service::submit(const Study& study) {
  const std::lock_guard lock(writing_);
  Submission submission = queue_.submit(study);
  changed_();
  return submission;
}

bool Service::cancel(const std::string& study_id) {
  const std::lock_guard lock(writing_);
  const bool known = queue_.cancel(study_id);
  changed_();
  return known;
}

Database Service::reader() const {
  Database database(data_.database(), Database::Access::read);
  database.execute_script("BEGIN");
  return database;
}

void Service::drain() { draining_ = true; }

void Service::tick() {
  const std::lock_guard lock(writing_);
  for (Run& run : runs_) look_after(run);
  std::erase_if(runs_, [](const Run& run) { return run.is_recorded; });
  queue_.give_back_expired();
  while (!draining_ && runs_.size() < cores_ && start_next()) {
  }
}

/// The environment's faults (a full disk, no process to be had) are not the case's: it goes back to the
/// queue.
bool Service::start_next() {
  std::optional<Claim> claim = queue_.claim();
  if (!claim) return false;
  const RunDirectory directory = data_.run(claim->case_id);
  try {
    directory.prepare(claim->document);
    claim->handle = executor_.start(directory);
  } catch (const std::exception& error) {
    queue_.interrupted(*claim, std::string("could not be started: ") + error.what());
    throw;
  }
  runs_.push_back({*claim, HistoryTail(directory.history_file()), clock_.now(), {}, {}});
  queue_.started(*claim, claim->handle);
  return true;
}

void Service::look_after(Run& run) {
  follow_history(run);
  if (clock_.now() - run.renewed >= JobQueue::kHeartbeat) {
    run.renewed = clock_.now();
    if (!queue_.renew(run.claim)) kill(run);
  }
  if (draining_ || queue_.is_to_be_cancelled(run.claim)) ask_to_stop(run);
  if (!run.end) run.end = executor_.poll(run.claim.handle);
  if (!run.end) return;
  Outcome outcome = outcome_of(*run.end, data_.run(run.claim.case_id));
  if (run.is_killed && outcome.kind == Outcome::Kind::crashed)
    outcome = {Outcome::Kind::interrupted, "it did not stop when it was asked to, and was killed", {}};
  record(run.claim, outcome);
  run.is_recorded = true;
}

void Service::follow_history(Run& run) {
  const std::size_t first = run.history.size();
  store_history(database_, run.claim.case_id, first, run.history.read_new());
}

void Service::ask_to_stop(Run& run) {
  if (!run.stop_asked) {
    run.stop_asked = clock_.now();
    executor_.cancel(run.claim.handle, Stop::checkpoint);
  } else if (clock_.now() - *run.stop_asked > kGrace) {
    kill(run);
  }
}

void Service::kill(Run& run) {
  if (!run.is_killed) executor_.cancel(run.claim.handle, Stop::kill);
  run.is_killed = true;
}

/// The end of the run and all that it left, in one transaction; nothing if the claim holds no longer.
void Service::record(const Claim& claim, const Outcome& outcome) {
  Transaction transaction(database_);
  if (!record_ending(claim, outcome)) return;
  HistoryTail whole(data_.run(claim.case_id).history_file());
  store_history(database_, claim.case_id, 0, whole.read_new());
  cut_history(database_, claim.case_id, whole.size());
  if (outcome.result) store_result(database_, claim.case_id, *outcome.result);
  transaction.commit();
}

bool Service::record_ending(const Claim& claim, const Outcome& outcome) {
  switch (outcome.kind) {
    case Outcome::Kind::done:
      return queue_.finish(claim, Ending::done, outcome.message);
    case Outcome::Kind::failed:
      return queue_.finish(claim, Ending::failed, outcome.message);
    case Outcome::Kind::diverged:
      return queue_.finish(claim, Ending::diverged, outcome.message);
    case Outcome::Kind::interrupted:
      return queue_.interrupted(claim, outcome.message);
    case Outcome::Kind::crashed:
      break;
  }
  return queue_.crashed(claim, outcome.message);
}

}  // namespace capstan
