#pragma once
// The interface between the daemon and the processes that compute: start, poll, stop. Everything else the
// daemon learns from the run directories.
#include <optional>
#include <string>

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

class Executor {
 public:
  virtual ~Executor() = default;

  /// Starts `capstan solve` in a prepared run directory. Throws std::system_error if that cannot be done,
  /// also while another process works in the directory.
  virtual RunHandle start(const RunDirectory& directory) = 0;

  /// How the run ended; nothing while it goes on. Called until it returns an end, and not after that.
  virtual std::optional<ProcessEnd> poll(const RunHandle& run) = 0;

  /// Nothing if the usage is not known.
  virtual std::optional<RunUsage> usage(const RunHandle& run) = 0;

  virtual void cancel(const RunHandle& run, StopBy stop) = 0;

  /// Waits until no process works in the directory; false if one still does after some seconds. For a daemon
  /// that takes over from one that was killed: the database may not have the handle of its last run.
  virtual bool wait_until_free(const RunDirectory& directory) = 0;
};

}  // namespace capstan
