#pragma once
// Supervision of one run: progress checks, limits, the lease, stopping and killing.
#include <chrono>
#include <optional>
#include <string>

#include "runner/daemon/executor.hpp"
#include "runner/queue/job_queue.hpp"
#include "runner/store/clock.hpp"

namespace capstan {

/// What one attempt may take; 0 for no limit. A case that exceeds a limit has failed and is not tried again.
struct RunLimits {
  double memory_mb = 0;               ///< resident
  std::chrono::seconds wall_time{0};  ///< of one attempt
};

/// Used by the thread of the loop alone.
class RunSupervision {
 public:
  /// A run that was asked to stop and has not ended after this time is killed.
  static constexpr std::chrono::seconds kGrace{8};

  /// \param claim      the run has been started: its handle is set
  /// \param heartbeat  time between two progress checks, and between two renewals of the lease
  RunSupervision(Claim claim, Executor& executor, const Clock& clock, RunLimits limits,
                 std::chrono::milliseconds heartbeat);

  /// At each heartbeat: kills a run that has not used any processor time for the duration of a lease
  /// (kHeartbeats heartbeats).
  void check_progress();
  /// Kills a run that uses too much memory. Asks one that takes too long to stop: it may write a checkpoint,
  /// from which `capstan retry` resumes.
  void enforce_limits();
  /// Asks for a checkpoint the first time, and kills the run when it is called more than kGrace later.
  void ask_to_stop();
  void kill();
  /// Asks the executor whether the run has ended.
  void poll() { end_ = executor_->poll(claim_.handle); }
  /// At each heartbeat: renews the lease, and kills the run if its claim is no longer valid.
  void keep_lease(JobQueue& queue);

  const Claim& claim() const { return claim_; }
  /// How the process ended; nothing while it runs.
  const std::optional<ProcessEnd>& end() const { return end_; }
  /// The limit that the run has exceeded, as a sentence; "" if none.
  const std::string& exceeded_limit() const { return exceeded_limit_; }
  bool has_stalled() const { return idle_heartbeats_ >= JobQueue::kHeartbeats; }
  bool is_asked_to_stop() const { return stop_asked_.has_value(); }
  bool is_killed() const { return is_killed_; }

 private:
  Claim claim_;
  Executor* executor_;
  const Clock* clock_;
  RunLimits limits_;
  std::chrono::milliseconds heartbeat_;

  Time renewed_;                                          ///< when the lease was renewed last
  std::chrono::milliseconds started_, progress_checked_;  ///< on the clock's elapsed()
  double cpu_seconds_ = 0;                                ///< at the last progress check
  int idle_heartbeats_ = 0;                               ///< in succession, without processor time
  std::optional<std::chrono::milliseconds> stop_asked_;   ///< on the clock's elapsed()
  bool is_killed_ = false;
  std::string exceeded_limit_;
  std::optional<ProcessEnd> end_;
};

}  // namespace capstan
