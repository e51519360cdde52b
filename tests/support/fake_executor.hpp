#pragma once
// An executor without processes: the test decides when and how each run ends.
#include <map>
#include <vector>

#include "runner/daemon/executor.hpp"

namespace capstan {

class FakeExecutor : public Executor {
 public:
  explicit FakeExecutor(std::size_t cores = 2) : cores_(cores) {}

  std::size_t slots() const override { return cores_; }
  std::string slot_name() const override { return "cores"; }
  bool has_room(std::size_t runs, std::size_t /*waiting*/) override { return runs < cores_; }

  RunHandle start(const Claim&, const RunDirectory& directory) override {
    if (is_broken) throw std::runtime_error("cannot start a process");
    const RunHandle run = "run " + std::to_string(++count_);
    directories.emplace(run, directory);
    running.push_back(run);
    return run;
  }

  std::optional<ProcessEnd> poll(const RunHandle& run) override {
    const auto end = ends_.find(run);
    return end == ends_.end() ? std::nullopt : std::optional(end->second);
  }

  /// One more second of processor time at each call, unless `is_stopped`.
  std::optional<RunUsage> usage(const RunHandle&) override {
    if (!is_stopped) usage_.cpu_seconds += 1;
    return usage_;
  }
  bool wait_until_free(const RunDirectory&) override { return true; }
  RunPlace place(const RunHandle& run) const override { return {false, "running", "process of " + run}; }

  void cancel(const RunHandle& run, StopBy stop) override {
    (stop == StopBy::kill ? killed : asked_to_stop).push_back(run);
    if (stop == StopBy::kill) end(run, {ProcessEnd::How::signalled, 9});
  }

  void end(const RunHandle& run, ProcessEnd how) {
    ends_[run] = how;
    std::erase(running, run);
  }
  void exit(const RunHandle& run, int code) { end(run, {ProcessEnd::How::exited, code}); }

  void take_memory(double mb) { usage_.memory_mb = mb; }

  bool is_broken = false;
  bool is_stopped = false;
  std::vector<RunHandle> running;  ///< in the order of their start
  std::vector<RunHandle> asked_to_stop, killed;
  std::map<RunHandle, RunDirectory> directories;

 private:
  const std::size_t cores_;
  int count_ = 0;
  RunUsage usage_;
  std::map<RunHandle, ProcessEnd> ends_;
};

}  // namespace capstan
