#pragma once
// Runs as child processes on this machine, one a case, each in its own process group.
#include <filesystem>
#include <map>

#include "runner/daemon/executor.hpp"
#include "runner/daemon/process_identity.hpp"

namespace capstan {

/// To be used from one thread, and one that lives as long as its runs are to: see end_with_daemon.
class LocalExecutor : public Executor {
 public:
  /// \param program  started as PROGRAM solve CASE.json --out DIR; by default the very program that is
  /// running, even
  ///                 if its file has been replaced since
  explicit LocalExecutor(std::filesystem::path program = "/proc/self/exe");

  RunHandle start(const RunDirectory& directory) override;
  std::optional<ProcessEnd> poll(const RunHandle& run) override;
  std::optional<RunUsage> usage(const RunHandle& run) override;
  void cancel(const RunHandle& run, StopBy stop) override;
  bool wait_until_free(const RunDirectory& directory) override;

 private:
  std::filesystem::path program_;
  std::map<RunHandle, ProcessIdentity> children_;
};

}  // namespace capstan
