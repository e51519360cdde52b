#pragma once
// Where runs run: the only seam to processes. The daemon starts runs, asks for them, and ends them;
// everything else it learns from their run directories.
#include <optional>
#include <string>

#include "runner/recording/process_end.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// The executor's name of a run. It is stored, so that a later daemon can find the run of an earlier one.
using RunHandle = std::string;

enum class StopBy {
  checkpoint,  ///< write a checkpoint, then end
  kill,        ///< end now; the run is gone on return, or poll says when
};

/// What a run has taken so far.
struct RunUsage {
  double cpu_seconds = 0;
  double memory_mb = 0;  ///< resident now
};

class Executor {
 public:
  virtual ~Executor() = default;

  /// Starts `capstan solve` in a prepared run directory. Throws std::system_error when that cannot be done,
  /// and while an earlier process, of whichever daemon, still works there.
  virtual RunHandle start(const RunDirectory& directory) = 0;

  /// Nothing while the run goes on; its end, once.
  virtual std::optional<ProcessEnd> poll(const RunHandle& run) = 0;

  /// Nothing if that cannot be told.
  virtual std::optional<RunUsage> usage(const RunHandle& run) = 0;

  virtual void cancel(const RunHandle& run, StopBy stop) = 0;

  /// Waits for the end of whatever works in the directory; false if it does not end in some seconds. To be
  /// asked by a daemon that takes over, whose predecessor may have died before it could say what it had
  /// started.
  virtual bool wait_until_free(const RunDirectory& directory) = 0;
};

}  // namespace capstan
