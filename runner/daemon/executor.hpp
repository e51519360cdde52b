#pragma once
// The interface between the daemon and the processes that compute: start, poll, stop. Everything else the
// daemon learns from the run directories. Two implementations: child processes on this machine, and jobs of a
// cluster.
#include <optional>
#include <string>

#include "runner/queries/run_place.hpp"
#include "runner/queue/job_queue.hpp"
#include "runner/recording/process_end.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// The executor's name for a run. It is stored in the database, so that a later daemon can find the run.
using RunHandle = std::string;

enum class StopBy {
  checkpoint,  ///< asks the run to write a checkpoint and end
  kill,        ///< ends the run now; poll tells when it is gone
};

struct RunUsage {
  double cpu_seconds = 0;  ///< since the start of the run
  double memory_mb = 0;    ///< resident now
};

/// Used by the thread of the loop alone, but for place, obstacle, slots and metrics, which other threads may
/// call, too.
class Executor {
 public:
  virtual ~Executor() = default;

  /// Number of cases that compute at the same time, at most.
  virtual std::size_t slots() const = 0;
  /// What the slots are: "cores", "jobs of Slurm".
  virtual std::string slot_name() const = 0;
  /// Whether another run may be started now.
  /// \param runs     number of runs whose end is not recorded yet
  /// \param waiting  number of cases that wait for their start
  virtual bool has_room(std::size_t runs, std::size_t waiting) = 0;

  /// Starts `capstan solve` in a prepared run directory that has the claim's token. Throws std::system_error
  /// if that cannot be done, also while another process works in the directory.
  virtual RunHandle start(const Claim& claim, const RunDirectory& directory) = 0;

  /// Takes over a run that an earlier daemon started. False if this executor knows nothing of it, or if its
  /// runs end with their daemon.
  virtual bool adopt(const Claim& /*claim*/, const RunDirectory& /*directory*/) { return false; }

  /// Whether runs go on when the daemon ends, so that the next one adopts them.
  virtual bool outlives_daemon() const { return false; }

  /// Passes on what start and cancel asked for, and asks how all runs are. The loop calls it before each tick
  /// without holding a lock, as a cluster may take its time to answer.
  virtual void exchange() {}

  /// How the run ended; nothing while it goes on. Called until it returns an end, and not after that.
  virtual std::optional<ProcessEnd> poll(const RunHandle& run) = 0;

  /// Nothing if the usage is not known.
  virtual std::optional<RunUsage> usage(const RunHandle& run) = 0;

  virtual void cancel(const RunHandle& run, StopBy stop) = 0;

  /// Waits until no process works in the directory; false if one still does after some seconds. For a daemon
  /// that takes over from one that was killed: the database may not have the handle of its last run.
  virtual bool wait_until_free(const RunDirectory& directory) = 0;

  virtual RunPlace place(const RunHandle& run) const = 0;
  /// Why no run can be started, as a sentence; "" if runs can be.
  virtual std::string obstacle() const { return ""; }
  /// In Prometheus' text format.
  virtual std::string metrics() const { return ""; }
};

}  // namespace capstan
