#pragma once
// The daemon's work: takes studies, keeps the cores busy with their cases, and records what comes of them.
//
// Everything that it knows is in the database and the run directories; killed at any moment, its successor
// goes on.
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "runner/execute/executor.hpp"
#include "runner/queue/clock.hpp"
#include "runner/queue/database.hpp"
#include "runner/queue/job_queue.hpp"
#include "runner/results/history.hpp"
#include "runner/service/data_directory.hpp"
#include "runner/service/outcome.hpp"

namespace capstan {

/// What one case may take; 0: as much as it wants. A case that goes beyond has failed: the same again would,
/// too.
struct Limits {
  double memory_mb = 0;
  std::chrono::seconds wall_time{0};  ///< of one attempt
};

class Service {
 public:
  /// A run that was asked to stop and has not after this time is killed.
  static constexpr std::chrono::seconds kGrace{8};

  /// Takes over what an earlier daemon left: its runs are ended, recorded if they are complete, and queued if
  /// not.
  Service(const DataDirectory& data, Executor& executor, const Clock& clock, int cores, Limits limits = {});

  // From any thread:
  Database reader() const;  ///< sees one moment, as long as it lives
  /// \param key  of an Idempotency-Key, or ""; throws KeyReused if it came with another study before
  Submission submit(const Study& study, const std::string& key = "");
  // False if there is no such study.
  bool cancel(const std::string& study_id);
  bool set_priority(const std::string& study_id, int priority);
  bool pause(const std::string& study_id, bool is_paused);
  bool retry(const std::string& study_id);

  const DataDirectory& data() const { return data_; }
  std::size_t cores() const { return cores_; }

  /// Called after a change that the loop should look at soon.
  void on_change(std::function<void()> callback) { changed_ = std::move(callback); }

  // From the thread of the loop:
  /// Records what the runs have done, ends those that must end, and starts as many as there are cores.
  void tick();
  /// From now on nothing is started, and what runs writes a checkpoint and ends.
  void drain();
  bool is_idle() const { return runs_.empty(); }

 private:
  struct Run {
    Claim claim;
    HistoryTail history;
    Time renewed;
    Time started;
    double cpu_seconds = 0;  ///< when the lease was renewed
    std::optional<Time> stop_asked = {};
    std::optional<RunEnd> end = {};
    bool is_killed = false;
    std::string beyond = {};  ///< the limit that it went beyond
    bool stood_still = false;
    bool is_recorded = false;
  };

  bool write(const std::function<bool()>& change);
  void take_over();
  bool start_next();
  void look_after(Run& run);
  void follow_history(Run& run);
  void keep_lease(Run& run);
  void hold_to_limits(Run& run);
  Outcome outcome_of_run(const Run& run) const;
  void ask_to_stop(Run& run);
  void kill(Run& run);
  void record(const Claim& claim, const Outcome& outcome);
  bool record_ending(const Claim& claim, const Outcome& outcome);

  const DataDirectory& data_;
  Executor& executor_;
  const Clock& clock_;
  const std::size_t cores_;
  const Limits limits_;
  std::function<void()> changed_ = [] {};

  std::mutex writing_;  ///< guards database_ and queue_
  Database database_;
  JobQueue queue_;
  std::vector<Run> runs_;
  bool draining_ = false;
};

}  // namespace capstan
