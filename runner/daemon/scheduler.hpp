#pragma once
// Keeps the cores busy: starts runs, supervises them, and records what they leave.
#include <exception>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "runner/daemon/free_space.hpp"
#include "runner/daemon/queue_writer.hpp"
#include "runner/daemon/run_supervision.hpp"
#include "runner/recording/history.hpp"
#include "runner/store/data_directory.hpp"

namespace capstan {

/// Used by the thread of the loop alone.
class Scheduler {
 public:
  Scheduler(QueueWriter& writer, Executor& executor, const Clock& clock, const DataDirectory& data,
            const FreeSpace& free_space, RunLimits limits);

  /// One round: supervises and records the runs, then starts new ones where there is room. An error that
  /// concerns one run does not keep the others from their turn; the last error is thrown at the end. The
  /// caller holds the writer's mutex.
  void tick();
  /// From now on no run is started. Those that run are asked to write a checkpoint and end, or are left to
  /// the next daemon if the executor's runs outlive this one.
  void drain();
  /// Adds a run that was started already, such as one that the executor has adopted.
  void supervise_run(const Claim& claim);
  /// True if no process is left. An outcome may still have to be recorded, for example if the disk is full.
  bool has_ended() const;
  /// True once the daemon ends and its runs go on without it: then nobody is asked about them any more.
  bool has_left_runs() const { return draining_ && executor_.outlives_daemon(); }
  /// True if there is no run, not even one that has still to be recorded.
  bool is_idle() const { return runs_.empty(); }

 private:
  struct Run {
    RunSupervision supervision;
    HistoryTail history;
    std::size_t ticks_since_read = 0;  ///< of the history
    bool is_recorded = false;
  };

  std::exception_ptr for_each_run(const std::function<void(Run&)>& action);
  void supervise(RunSupervision& run);
  void record(Run& run);
  bool has_run(const Claim& claim) const;
  void record_news(Run& run);
  std::exception_ptr read_cancellations();
  void start_runs();
  bool start_next();
  void start_process(Claim& claim, const RunDirectory& directory);
  void add_run(const Claim& claim);

  QueueWriter& writer_;
  Executor& executor_;
  const Clock& clock_;
  const DataDirectory& data_;
  const FreeSpace& free_space_;
  const RunLimits limits_;
  std::vector<Run> runs_;
  std::set<std::string> to_be_cancelled_;  ///< tokens
  bool draining_ = false;
};

}  // namespace capstan
