#pragma once
// The queue's protocol and its whole vocabulary: claim, lease, heartbeat, end, give back, retry.
// A case is executed at least once and its result is recorded exactly once.
//
// clang-format off
//                    submit
//                      │
//                      ▼
//     ┌───────────▶ queued ──cancel──▶ cancelled ──submit again──▶ queued
//     │              │  ▲
//     │        claim │  └───retry───┐
//     │              ▼              │
//     └────────── running ──end──▶ failed, done, diverged
//     put_back,
//     lease expired,
//     end: interrupted, crashed for the first time
// clang-format on
//
// A running case whose cancellation was requested is cancelled where it would be queued again.
#include <chrono>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "runner/store/clock.hpp"
#include "runner/store/database.hpp"
#include "solver/run_directory/run_ending.hpp"

namespace capstan {

/// The right to run one case. Every later call about the run presents the token.
struct Claim {
  std::string case_id;
  std::string document;  ///< case.json
  std::string token;
  int attempt = 0;
  std::string handle;  ///< the executor's name for the run, once it has started
};

class JobQueue {
 public:
  static constexpr std::chrono::seconds kLease{60};
  static constexpr int kHeartbeats = 6;  ///< in one lease
  static constexpr int kMaxCrashes = 2;
  static constexpr std::chrono::seconds kBackOff{5};  ///< between a crash and the next attempt

  /// \param database  the writer; callers from several threads take turns by a lock of their own
  JobQueue(Database& database, const Clock& clock, std::chrono::milliseconds lease = kLease)
      : database_(database), clock_(clock), lease_(lease) {}

  /// Time between two renewals of a claim.
  std::chrono::milliseconds heartbeat() const { return lease_ / kHeartbeats; }

  // The following return a number of cases; nothing if there is no such study.
  /// Cancels the queued cases that no other study wants, and requests the cancellation of the running ones.
  /// Returns the number of both.
  std::optional<int> cancel(const std::string& study_id);
  /// Studies of higher priority are served first; the default is 0. Returns the number of queued cases.
  std::optional<int> set_priority(const std::string& study_id, int priority);
  /// No case of a paused study is started; running cases continue. Returns the number of queued cases.
  std::optional<int> pause(const std::string& study_id, bool is_paused);
  /// Queues the failed cases again, unless the study is cancelled. Returns their number.
  std::optional<int> retry(const std::string& study_id);

  /// Claims the next case: of the studies with the highest priority, the one served longest ago; of that
  /// study, the first waiting point. Nothing if no case can be started.
  std::optional<Claim> claim();

  /// Claims this case; nothing if it is not queued. For a result that was computed elsewhere.
  std::optional<Claim> claim_case(const std::string& case_id);

  /// Stores the executor's name for the run.
  void started(const Claim& claim, const std::string& handle);

  // The following return false if the token is no longer valid: then nothing is recorded, and the run must be
  // stopped.
  /// Undoes a claim whose run could not be started. This does not count as an attempt. The case waits for
  /// kBackOff, so that others are started meanwhile.
  bool put_back(const Claim& claim, const std::string& reason);
  /// Heartbeat: extends the lease.
  bool renew(const Claim& claim);
  /// Ends the attempt. The case becomes done, failed or diverged. After an interruption or a crash it is
  /// queued again; after kMaxCrashes crashes it becomes failed.
  bool end(const Claim& claim, RunEnding ending, const std::string& reason);

  /// Tokens of the running cases whose cancellation was requested.
  std::set<std::string> to_be_cancelled();

  /// Number of queued cases.
  std::size_t waiting();

  /// All claims: a new daemon reconciles them with the run directories.
  std::vector<Claim> running();

  /// Queues the cases whose lease has expired. Returns their number.
  /// \param is_held  returns true for a run that the caller still supervises. Its lease has expired because
  ///                 the clock was set forward: it is renewed instead
  int give_back_expired(const std::function<bool(const Claim&)>& is_held = [](const Claim&) {
    return false;
  });

 private:
  std::optional<Claim> claim_queued(const std::string& case_id, Time now);
  std::optional<int> queued_cases(const std::string& study_id);
  bool end_attempt(const Claim& claim, RunEnding ending, const std::string& reason);
  void requeue(const Claim& claim, const std::string& reason);
  void requeue_after_crash(const Claim& claim, const std::string& reason);

  Database& database_;
  const Clock& clock_;
  const std::chrono::milliseconds lease_;
};

}  // namespace capstan
