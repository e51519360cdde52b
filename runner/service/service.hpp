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

class Service {
 public:
  /// A run that was asked to stop and has not after this time is killed.
  static constexpr std::chrono::seconds kGrace{8};

  /// Takes over what an earlier daemon left: its runs are ended, recorded if they are complete, and queued if
  /// not.
  Service(const DataDirectory& data, Executor& executor, const Clock& clock, int cores);

  // From any thread:
  Submission submit(const Study& study);
  bool cancel(const std::string& study_id);  ///< false if there is no such study
  Database reader() const;                   ///< sees one moment, as long as it lives

  const DataDirectory& data() const { return data_; }

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
    std::optional<Time> stop_asked;
    std::optional<RunEnd> end;
    bool is_killed = false;
    bool is_recorded = false;
  };

  void take_over();
  bool start_next();
  void look_after(Run& run);
  void follow_history(Run& run);
  void ask_to_stop(Run& run);
  void kill(Run& run);
  void record(const Claim& claim, const Outcome& outcome);
  bool record_ending(const Claim& claim, const Outcome& outcome);

  const DataDirectory& data_;
  Executor& executor_;
  const Clock& clock_;
  const std::size_t cores_;
  std::function<void()> changed_ = [] {};

  std::mutex writing_;  ///< guards database_ and queue_
  Database database_;
  JobQueue queue_;
  std::vector<Run> runs_;
  bool draining_ = false;
};

}  // namespace capstan
