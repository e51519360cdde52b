#pragma once
// Runs as child processes of the daemon on this machine.
#include <filesystem>
#include <map>

#include "runner/daemon/executor.hpp"
#include "runner/daemon/process_identity.hpp"

namespace capstan {

/// Its thread has to live as long as the runs: a worker is killed when the thread that started
/// it ends (solver/run_directory/parent_daemon.hpp).
class LocalExecutor : public Executor {
 public:
  /// \param cores    max number of runs at the same time
  /// \param program  started as PROGRAM solve CASE.json --out DIR. By default the program that is running,
  ///                 even if its file has been replaced since its start
  explicit LocalExecutor(int cores, std::filesystem::path program = "/proc/self/exe");

  std::size_t slots() const override { return cores_; }
  std::string slot_name() const override { return cores_ == 1 ? "core" : "cores"; }
  bool has_room(std::size_t runs, std::size_t /*waiting*/) override { return runs < cores_; }
  RunHandle start(const Claim& claim, const RunDirectory& directory) override;
  std::optional<ProcessEnd> poll(const RunHandle& run) override;
  std::optional<RunUsage> usage(const RunHandle& run) override;
  void cancel(const RunHandle& run, StopBy stop) override;
  bool wait_until_free(const RunDirectory& directory) override;
  RunPlace place(const RunHandle& run) const override;

 private:
  const std::size_t cores_;
  const std::filesystem::path program_;
  std::map<RunHandle, ProcessIdentity> children_;  ///< not reaped yet
};

}  // namespace capstan
