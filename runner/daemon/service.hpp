#pragma once
// The daemon's work: takes studies, keeps the cores busy with their cases, and records what comes of them.
//
// Everything that it knows is in the database and the run directories; killed at any moment, its successor
// goes on.
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "runner/daemon/delete_study.hpp"
#include "runner/daemon/executor.hpp"
#include "runner/daemon/submit_study.hpp"
#include "runner/queue/job_queue.hpp"
#include "runner/recording/history.hpp"
#include "runner/recording/outcome.hpp"
#include "runner/store/clock.hpp"
#include "runner/store/data_directory.hpp"
#include "runner/store/database.hpp"
#include "runner/store/readers.hpp"

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
  /// \param lease  how long a run may stand still
  Service(const DataDirectory& data, Executor& executor, const Clock& clock, int cores, Limits limits = {},
          std::chrono::milliseconds lease = JobQueue::kLease);

  // From any thread:
  Readers::Reader reader() { return readers_.take(); }
  /// Safe on the disk on return; those that wait for the disk at the same time are written together.
  /// \param key  of an Idempotency-Key, or ""; throws KeyReused if it came with another study before
  Submission submit(const Study& study, const std::string& key = "");
  // How many cases they concern; nothing if there is no such study.
  std::optional<int> cancel(const std::string& study_id);
  std::optional<int> set_priority(const std::string& study_id, int priority);
  std::optional<int> pause(const std::string& study_id, bool is_paused);
  std::optional<int> retry(const std::string& study_id);
  /// Of the study; its cases go with it, unless another study wants them.
  std::optional<Deletion> remove(const std::string& study_id);
  /// At another fidelity, which may help diverged cases, too; the faults that this one would have. Of an
  /// unknown study there is nothing to retry.
  Issues retry_at(const std::string& study_id, const nlohmann::json& fidelity);

  /// While less is free where the runs write, nothing is started.
  void keep_free(std::uintmax_t bytes) { kept_free_ = bytes; }
  /// For people; "" if nothing stands in the way of all cases.
  std::string why_nothing_starts() const;
  /// Remembers that the database has turned out to be damaged: from now on nothing is written to it.
  void report_damage(const std::string& what);
  /// Throws DatabaseError if the database is damaged, or its files were removed or replaced.
  void expect_sound_database() const;

  const DataDirectory& data() const { return data_; }
  std::size_t cores() const { return cores_; }

  /// Called after a change that the loop should look at soon.
  void on_change(std::function<void()> callback) { changed_ = std::move(callback); }

  // From the thread of the loop:
  /// Records what the runs have done, ends those that must end, and starts as many as there are cores.
  void tick();
  /// From now on nothing is started, and what runs writes a checkpoint and ends.
  void drain();
  /// No process is left. What came of them may still have to be recorded, if the disk was full.
  bool has_ended() const;
  bool is_idle() const { return runs_.empty(); }

 private:
  struct Run {
    Claim claim;
    HistoryTail history;
    Time renewed;
    std::chrono::milliseconds started, progress_checked;  ///< on the clock's elapsed()
    double cpu_seconds = 0;                               ///< when its pulse was felt
    int idle_heartbeats = 0;                              ///< heartbeats without computing
    std::optional<std::chrono::milliseconds> stop_asked = {};
    std::optional<ProcessEnd> end = {};
    bool is_killed = false;
    std::string beyond = {};  ///< the limit that it went beyond
    bool is_recorded = false;
  };

  /// A study whose client waits.
  struct Waiting {
    const Study& study;
    const std::string& key;
    Submission submission = {};
    std::exception_ptr error = {};
    bool is_answered = false;
  };

  void submit_waiting();
  void delete_unwanted();
  std::optional<int> write(const std::function<std::optional<int>()>& change);
  std::exception_ptr for_each_run(const std::function<void(Run&)>& action);
  bool has_run(const Claim& claim) const;
  void take_over();
  bool start_next();
  void or_put_back(const Claim& claim, const std::function<void()>& action);
  void spawn(Claim& claim);
  void follow(const Claim& claim);
  void look_after(Run& run);
  void write_down(Run& run);
  void keep_lease(Run& run);
  void check_progress(Run& run);
  void hold_to_limits(Run& run);
  RunOutcome outcome_of_run(const Run& run) const;
  void ask_to_stop(Run& run);
  void kill(Run& run);
  void record(const Claim& claim, const RunOutcome& outcome);
  void remove_spare_checkpoints(const std::string& case_id, RunEnding ending) const;

  const DataDirectory& data_;
  Executor& executor_;
  const Clock& clock_;
  const std::size_t cores_;
  const Limits limits_;
  std::uintmax_t kept_free_ = kMinFree;
  std::function<void()> changed_ = [] {};

  mutable std::mutex damage_mutex_;
  std::string damage_;  ///< of the database, "" while none is known
  std::mutex joining_;  ///< guards waiting_; never held while waiting for the other one
  std::deque<Waiting*> waiting_;
  std::mutex submitting_;  ///< held by the one client that waits for writing_ in order to submit
  std::mutex writing_;     ///< guards database_ and queue_
  Database database_;
  Readers readers_;
  JobQueue queue_;
  std::vector<Run> runs_;
  bool draining_ = false;
};

}  // namespace capstan
