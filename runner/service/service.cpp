#include "runner/service/service.hpp"

#include <algorithm>

#include "runner/queue/fail_point.hpp"
#include "runner/results/result.hpp"

namespace capstan {
namespace {

std::string whole(double number) { return std::to_string(static_cast<long long>(number)); }

}  // namespace

Service::Service(const DataDirectory& data, Executor& executor, const Clock& clock, int cores, Limits limits)
    : data_(data),
      executor_(executor),
      clock_(clock),
      cores_(static_cast<std::size_t>(cores)),
      limits_(limits),
      database_(data.database(), Database::Access::write),
      queue_(database_, clock) {
  take_over();
}

void Service::take_over() {
  for (const Claim& claim : queue_.running()) {
    const RunDirectory directory = data_.run(claim.case_id);
    executor_.cancel(claim.handle, Stop::kill);
    executor_.wait_until_free(directory);
    record(claim, outcome_of(RunEnd{}, directory));
  }
}

Submission Service::submit(const Study& study, const std::string& key) {
  const std::lock_guard lock(writing_);
  Submission submission = queue_.submit(study, key);
  changed_();
  return submission;
}

bool Service::write(const std::function<bool()>& change) {
  const std::lock_guard lock(writing_);
  const bool known = change();
  changed_();
  return known;
}

bool Service::cancel(const std::string& study_id) {
  return write([&] { return queue_.cancel(study_id); });
}

bool Service::set_priority(const std::string& study_id, int priority) {
  return write([&] { return queue_.set_priority(study_id, priority); });
}

bool Service::pause(const std::string& study_id, bool is_paused) {
  return write([&] { return queue_.pause(study_id, is_paused); });
}

bool Service::retry(const std::string& study_id) {
  return write([&] { return queue_.retry(study_id); });
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
    fail_point("prepared");
    claim->handle = executor_.start(directory);
    fail_point("spawned");
  } catch (const std::exception& error) {
    queue_.interrupted(*claim, std::string("could not be started: ") + error.what());
    throw;
  }
  runs_.push_back({*claim, HistoryTail(directory.history_file()), clock_.now(), clock_.now()});
  queue_.started(*claim, claim->handle);
  fail_point("started");
  return true;
}

void Service::look_after(Run& run) {
  follow_history(run);
  keep_lease(run);
  hold_to_limits(run);
  if (draining_ || queue_.is_to_be_cancelled(run.claim)) ask_to_stop(run);
  if (!run.end) run.end = executor_.poll(run.claim.handle);
  if (!run.end) return;
  record(run.claim, outcome_of_run(run));
  run.is_recorded = true;
}

/// A lease is renewed only while the process computes: one that was stopped or hangs loses it, and is killed.
void Service::keep_lease(Run& run) {
  const Time now = clock_.now();
  if (now - run.renewed < JobQueue::kHeartbeat) return;
  const auto usage = executor_.usage(run.claim.handle);
  if (usage && usage->cpu_seconds == run.cpu_seconds) {
    run.stood_still = now - run.renewed >= JobQueue::kLease;
    if (run.stood_still) kill(run);
    return;
  }
  if (usage) run.cpu_seconds = usage->cpu_seconds;
  run.renewed = now;
  if (!queue_.renew(run.claim)) kill(run);
}

void Service::hold_to_limits(Run& run) {
  if (!run.beyond.empty()) return;
  const auto usage = limits_.memory_mb > 0 ? executor_.usage(run.claim.handle) : std::nullopt;
  if (usage && usage->memory_mb > limits_.memory_mb)
    run.beyond =
        "it took " + whole(usage->memory_mb) + " MB of memory; the limit is " + whole(limits_.memory_mb);
  if (limits_.wall_time.count() > 0 && clock_.now() - run.started > limits_.wall_time)
    run.beyond = "it took longer than the limit of " + std::to_string(limits_.wall_time.count()) + " s";
  if (!run.beyond.empty()) kill(run);
}

/// A result stands, however its run ended. Else the daemon's own reasons to end a run go before what the
/// process's end looks like.
Outcome Service::outcome_of_run(const Run& run) const {
  Outcome outcome = outcome_of(*run.end, data_.run(run.claim.case_id));
  if (outcome.result || !run.is_killed) return outcome;
  using Kind = Outcome::Kind;
  if (!run.beyond.empty()) return {Kind::failed, run.beyond, {}};
  if (run.stood_still) return {Kind::crashed, "it stood still until its lease ran out, and was killed", {}};
  return {Kind::interrupted, "it did not stop when it was asked to, and was killed", {}};
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
  fail_point("recording");
  transaction.commit();
  fail_point("recorded");
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
