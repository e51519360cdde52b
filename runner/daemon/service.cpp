#include "runner/daemon/service.hpp"

#include <algorithm>

#include "runner/daemon/case_rows.hpp"
#include "runner/daemon/points.hpp"
#include "runner/daemon/replacement.hpp"
#include "runner/recording/result.hpp"
#include "runner/store/fail_point.hpp"
#include "runner/store/orphaned_runs.hpp"
#include "solver/case/content_id.hpp"
#include "solver/run_directory/checkpoint_files.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

std::string whole(double number) { return std::to_string(static_cast<long long>(number)); }

/// Where result.json cannot be read the case waits until it can be. A shortage of the daemon's own is thrown.
RunOutcome readable_outcome_of(const ProcessEnd& end, const RunDirectory& directory) try {
  return outcome_of(end, directory);
} catch (const std::filesystem::filesystem_error& error) {
  if (is_shortage(error)) throw;
  return {RunEnding::interrupted, error.what()};
}

}  // namespace

Service::Service(const DataDirectory& data, Executor& executor, const Clock& clock, int cores, Limits limits,
                 std::chrono::milliseconds lease)
    : data_(data),
      executor_(executor),
      clock_(clock),
      cores_(static_cast<std::size_t>(cores)),
      limits_(limits),
      database_(data.database(), Database::Access::write),
      readers_(data.database(), database_),
      queue_(database_, clock, lease) {
  take_over();
}

void Service::take_over() {
  for (const Claim& claim : queue_.running()) {
    const RunDirectory directory = data_.run(claim.case_id);
    executor_.cancel(claim.handle, StopBy::kill);
    executor_.wait_until_free(directory);
    directory.remove_partial_files();
    record(claim, readable_outcome_of(ProcessEnd{}, directory));
  }
  derive_old_points(database_);
  estimate_missing_costs(database_);
  replace_outdated(database_);
  for (const RunDirectory& orphan : orphaned_runs(data_.runs(), database_))
    if (orphan.is_worthless()) std::filesystem::remove_all(orphan.path());
}

Submission Service::submit(const Study& study, const std::string& key) {
  Waiting mine{study, key};
  {
    const std::lock_guard lock(joining_);
    waiting_.push_back(&mine);
  }
  {
    const std::lock_guard alone(submitting_);
    while (!mine.is_answered) {
      const std::lock_guard lock(writing_);
      submit_waiting();
    }
  }
  if (mine.error) std::rethrow_exception(mine.error);
  changed_();
  return mine.submission;
}

/// One commit, and one wait for the disk, for all whose clients came while the disk was busy; of large
/// studies only as many as let the loop have its turn soon.
void Service::submit_waiting() {
  constexpr std::size_t kManyCases = 5000;
  std::vector<Waiting*> together;
  {
    const std::lock_guard lock(joining_);
    std::size_t cases = 0;
    for (; !waiting_.empty() && cases < kManyCases; waiting_.pop_front()) {
      together.push_back(waiting_.front());
      cases += waiting_.front()->study.cases.size();
    }
  }
  std::exception_ptr error;
  try {
    expect_sound_database();
    Transaction transaction(database_);
    for (Waiting* each : together) try {
        each->submission = submit_study(database_, clock_, each->study, each->key);
      } catch (const KeyReused&) {  // has changed nothing, and concerns nobody else
        each->error = std::current_exception();
      }
    transaction.commit();
    fail_point("submitted");
  } catch (...) {
    error = std::current_exception();
  }
  for (Waiting* each : together) {
    if (error) each->error = error;
    each->is_answered = true;
  }
}

std::optional<int> Service::write(const std::function<std::optional<int>()>& change) {
  const std::lock_guard lock(writing_);
  expect_sound_database();
  const std::optional<int> cases = change();
  changed_();
  return cases;
}

std::optional<int> Service::cancel(const std::string& study_id) {
  return write([&] { return queue_.cancel(study_id); });
}

/// The rows go at the next ticks, the run directories after them.
std::optional<Deletion> Service::remove(const std::string& study_id) {
  std::optional<Deletion> deletion;
  write([&] {
    deletion = delete_study(database_, queue_, study_id);
    return deletion ? std::optional<int>(deletion->deleted) : std::nullopt;
  });
  return deletion;
}

std::optional<int> Service::set_priority(const std::string& study_id, int priority) {
  return write([&] { return queue_.set_priority(study_id, priority); });
}

std::optional<int> Service::pause(const std::string& study_id, bool is_paused) {
  return write([&] { return queue_.pause(study_id, is_paused); });
}

std::optional<int> Service::retry(const std::string& study_id) {
  return write([&] { return queue_.retry(study_id); });
}

Issues Service::retry_at(const std::string& study_id, const nlohmann::json& fidelity) {
  const std::lock_guard lock(writing_);
  expect_sound_database();
  Issues issues = replace_failed(database_, study_id, fidelity);
  changed_();
  return issues;
}

void Service::drain() { draining_ = true; }

bool Service::has_ended() const {
  return std::all_of(runs_.begin(), runs_.end(), [](const Run& run) { return run.end.has_value(); });
}

/// First the processes, then the database: a full disk must not keep a run from being stopped, nor what is
/// wrong with one run the others from being recorded.
void Service::tick() {
  const std::lock_guard lock(writing_);
  std::exception_ptr error = for_each_run([this](Run& run) { look_after(run); });
  expect_sound_database();
  if (const auto later = for_each_run([this](Run& run) { write_down(run); })) error = later;
  std::erase_if(runs_, [](const Run& run) { return run.is_recorded; });
  queue_.give_back_expired([this](const Claim& claim) { return has_run(claim); });
  delete_unwanted();
  while (!draining_ && runs_.size() < cores_ && start_next()) {
  }
  if (error) std::rethrow_exception(error);
}

/// The last of the errors, if there were any.
std::exception_ptr Service::for_each_run(const std::function<void(Run&)>& action) {
  std::exception_ptr error;
  for (Run& run : runs_) try {
      action(run);
    } catch (...) {
      error = std::current_exception();
    }
  return error;
}

bool Service::has_run(const Claim& claim) const {
  return std::any_of(runs_.begin(), runs_.end(),
                     [&](const Run& run) { return run.claim.token == claim.token; });
}

void Service::report_damage(const std::string& what) {
  const std::lock_guard lock(damage_mutex_);
  damage_ = what;
}

void Service::expect_sound_database() const {
  {
    const std::lock_guard lock(damage_mutex_);
    if (!damage_.empty()) throw DatabaseDamaged(damage_);
  }
  database_.expect_in_place();
}

std::string Service::why_nothing_starts() const {
  const std::filesystem::path runs = data_.runs();
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(runs, error);
  if (error)
    return runs.string() + ", where the runs write, cannot be used (" + error.message() +
           "): nothing is started until it is there again";
  if (space.available >= kept_free_) return "";
  return "less than " + std::to_string(kept_free_ / 1'000'000) + " MB are free in " + runs.string() +
         ": nothing is started";
}

/// A few at a time, so that nobody waits for long. A directory that cannot be removed is tried again.
void Service::delete_unwanted() {
  constexpr int kAtOnce = 50;
  std::vector<std::string> removed;
  for (const std::string& id : delete_unwanted_cases(database_, kAtOnce)) {
    std::error_code error;
    std::filesystem::remove_all(data_.run(id).path(), error);
    if (!error) removed.push_back(id);
  }
  forget_deleted(database_, removed);
}

/// A directory that is complete, of a case that nobody has recorded, is recorded: the database came back from
/// a backup, or a power failure took the last commit.
bool Service::start_next() {
  if (!why_nothing_starts().empty()) return false;
  std::optional<Claim> claim = queue_.claim();
  if (!claim) return false;
  const RunDirectory directory = data_.run(claim->case_id);
  bool is_complete = false;
  or_put_back(*claim, [&] {
    is_complete = directory.result().has_value();
    if (is_complete)
      record(*claim, outcome_of(ProcessEnd{}, directory));
    else
      spawn(*claim);
  });
  if (!is_complete) follow(*claim);
  return true;
}

/// The environment's faults (a full disk, no process to be had) are not the case's: it goes back to the
/// queue.
void Service::or_put_back(const Claim& claim, const std::function<void()>& action) try {
  action();
} catch (const std::exception& error) {
  queue_.put_back(claim, std::string("could not be started: ") + error.what());
  throw;
}

void Service::spawn(Claim& claim) {
  const RunDirectory directory = data_.run(claim.case_id);
  directory.prepare(claim.document);
  fail_point("prepared");
  claim.handle = executor_.start(directory);
  fail_point("spawned");
}

void Service::follow(const Claim& claim) {
  const auto elapsed = clock_.elapsed();
  runs_.push_back(
      {claim, HistoryTail(data_.run(claim.case_id).history_file()), clock_.now(), elapsed, elapsed});
  queue_.started(claim, claim.handle);
  fail_point("started");
}

void Service::look_after(Run& run) {
  if (run.end) return;
  check_progress(run);
  hold_to_limits(run);
  if (draining_ || queue_.is_to_be_cancelled(run.claim)) ask_to_stop(run);
  run.end = executor_.poll(run.claim.handle);
}

void Service::write_down(Run& run) {
  const std::size_t first = run.history.size();
  store_history(database_, run.claim.case_id, first, run.history.read_new());
  if (!run.end) return keep_lease(run);
  record(run.claim, outcome_of_run(run));
  run.is_recorded = true;
}

/// By the time of day, as the lease is: after a jump of the clock, either way, it is renewed at once.
void Service::keep_lease(Run& run) {
  const auto since = clock_.now() - run.renewed;
  if (run.is_killed || (since >= since.zero() && since < queue_.heartbeat())) return;
  run.renewed = clock_.now();
  if (!queue_.renew(run.claim)) kill(run);
}

/// Only a process that computes keeps its lease: one that was stopped or hangs is killed after as many still
/// heartbeats as a lease has.
void Service::check_progress(Run& run) {
  const auto now = clock_.elapsed();
  if (now - run.progress_checked < queue_.heartbeat()) return;
  run.progress_checked = now;
  const auto usage = executor_.usage(run.claim.handle);
  if (!usage) return;
  run.idle_heartbeats = usage->cpu_seconds == run.cpu_seconds ? run.idle_heartbeats + 1 : 0;
  run.cpu_seconds = usage->cpu_seconds;
  if (run.idle_heartbeats >= JobQueue::kHeartbeats) kill(run);
}

/// A run that takes too much memory is killed; one that takes too long may write a checkpoint, from which a
/// retry goes on.
void Service::hold_to_limits(Run& run) {
  const auto usage = limits_.memory_mb > 0 ? executor_.usage(run.claim.handle) : std::nullopt;
  if (run.beyond.empty() && usage && usage->memory_mb > limits_.memory_mb) {
    run.beyond =
        "it took " + whole(usage->memory_mb) + " MB of memory; the limit is " + whole(limits_.memory_mb);
    kill(run);
  }
  if (limits_.wall_time.count() <= 0 || clock_.elapsed() - run.started <= limits_.wall_time) return;
  if (run.beyond.empty())
    run.beyond = "it took longer than the limit of " + std::to_string(limits_.wall_time.count()) + " s";
  ask_to_stop(run);
}

/// A result stands, however its run ended. Else the daemon's own reasons to end a run go before what the
/// process's end looks like.
RunOutcome Service::outcome_of_run(const Run& run) const {
  RunOutcome outcome = readable_outcome_of(*run.end, data_.run(run.claim.case_id));
  const bool has_error = run.end->how == ProcessEnd::How::exited && run.end->number == kExitError;
  const bool has_directory = std::filesystem::exists(data_.run(run.claim.case_id).path());
  if (!outcome.result && has_error && !has_directory)
    return {RunEnding::interrupted, "its directory was removed"};
  if (!outcome.result && has_error && !why_nothing_starts().empty())
    return {RunEnding::interrupted, "the disk was full"};
  if (outcome.result) return outcome;
  if (!run.beyond.empty()) return {RunEnding::failed, run.beyond};
  if (run.is_killed && run.idle_heartbeats >= JobQueue::kHeartbeats)
    return {RunEnding::crashed, "it stood still until its lease ran out, and was killed"};
  if (run.is_killed) return {RunEnding::interrupted, "it did not stop when it was asked to, and was killed"};
  if (run.stop_asked && outcome.ending == RunEnding::crashed)
    return {RunEnding::interrupted,
            "it was asked to stop, and ended without a checkpoint: " + describe(*run.end)};
  return outcome;
}

void Service::ask_to_stop(Run& run) {
  if (!run.stop_asked) {
    run.stop_asked = clock_.elapsed();
    executor_.cancel(run.claim.handle, StopBy::checkpoint);
  } else if (clock_.elapsed() - *run.stop_asked > kGrace) {
    kill(run);
  }
}

void Service::kill(Run& run) {
  if (!run.is_killed) executor_.cancel(run.claim.handle, StopBy::kill);
  run.is_killed = true;
}

/// The end of the run and all that it left, in one transaction; nothing if the claim holds no longer.
void Service::record(const Claim& claim, const RunOutcome& outcome) {
  Transaction transaction(database_);
  if (!queue_.end(claim, outcome.ending, outcome.message)) return;
  store_history_file(database_, claim.case_id, read_history(data_.run(claim.case_id).history_file()));
  if (outcome.result) store_result(database_, claim.case_id, *outcome.result);
  fail_point("recording");
  transaction.commit();
  fail_point("recorded");
  remove_spare_checkpoints(claim.case_id, outcome.ending);
}

/// Of a case that is done the newest checkpoint is kept, which would be needed to prolong it; one that
/// diverged does the same again from any.
void Service::remove_spare_checkpoints(const std::string& case_id, RunEnding ending) const {
  if (ending != RunEnding::done && ending != RunEnding::diverged) return;
  const auto both = checkpoint_files(data_.run(case_id), case_id, kNumericsVersion);
  std::error_code ignored;  // they take room, no more
  std::filesystem::remove(both[1].path, ignored);
  if (ending == RunEnding::diverged) std::filesystem::remove(both[0].path, ignored);
}

}  // namespace capstan
