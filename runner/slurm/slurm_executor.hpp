#pragma once
// Runs as jobs of Slurm. Nothing but its commands is used: sbatch, squeue and scancel.
//
// A start puts the case on the list of a task. The next exchange writes the lists and submits the tasks as
// job arrays (sbatch). Each job computes the cases on its list (solve_list.hpp) and notes their ends in a
// journal. One squeue for all jobs tells which of them are waiting, running or gone.
//
// Recovery rests on names: an array has the name of its directory, which is written before sbatch is called,
// and the lists in it hold the token of each run. So a job is found again after sbatch timed out, and after a
// restart of the daemon. A job that Slurm does not list any more has lost the runs that its journal does not
// end; they are queued again with new tokens.
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "runner/daemon/executor.hpp"
#include "runner/slurm/job_request.hpp"
#include "runner/slurm/slurm_job.hpp"
#include "runner/store/clock.hpp"

namespace capstan {

class SlurmExecutor : public Executor {
 public:
  /// \param runs  the directory of the run directories, on a file system that the nodes see, too. The files
  ///              of the jobs are kept in its directory `jobs`
  SlurmExecutor(SlurmSettings settings, const std::filesystem::path& runs, const Clock& clock);

  std::size_t slots() const override { return settings_.jobs; }
  std::string slot_name() const override { return settings_.jobs == 1 ? "job of Slurm" : "jobs of Slurm"; }
  bool has_room(std::size_t runs, std::size_t waiting) override;
  RunHandle start(const Claim& claim, const RunDirectory& directory) override;
  bool adopt(const Claim& claim, const RunDirectory& directory) override;
  bool outlives_daemon() const override { return true; }
  void exchange() override;
  std::optional<ProcessEnd> poll(const RunHandle& run) override;
  /// Slurm enforces the limits of memory and time.
  std::optional<RunUsage> usage(const RunHandle& /*run*/) override { return std::nullopt; }
  /// Withdraws the run: it publishes nothing any more, and its end is known at once. A job none of whose runs
  /// is wanted is cancelled.
  void cancel(const RunHandle& run, StopBy stop) override;
  /// True: a process that still works there publishes nothing (attempt_token.hpp).
  bool wait_until_free(const RunDirectory& /*directory*/) override { return true; }

  RunPlace place(const RunHandle& run) const override;
  std::string obstacle() const override;
  std::string metrics() const override;

 private:
  /// A task that is not submitted yet.
  struct PreparedTask {
    std::vector<RunHandle> runs = {};
    double seconds = 0;  ///< expected, on one core
    double bytes = 0;    ///< of the largest case
  };
  /// Where to find a run.
  struct Address {
    std::string job;  ///< "" while it is not submitted
    int task = 0;
    std::size_t position = 0;
  };
  /// A run before it is submitted.
  struct PreparedRun {
    ListedCase listed;
    int attempt;
    std::optional<ProcessEnd> end = {};
  };
  /// What other threads are told.
  struct View {
    std::map<RunHandle, RunPlace> places = {};
    std::map<std::pair<std::string, std::string>, int> tasks = {};  ///< by state and reason
    std::string obstacle = {};
    bool is_answering = true;
  };

  bool is_full(const PreparedTask& task) const;
  std::size_t open_tasks() const;
  SlurmRun* find(const RunHandle& run);
  void learn_from(const ProcessEnd& end, const SlurmTask& task);
  void find_earlier_jobs();

  bool is_time_to_ask() const;
  void ask();
  void submit_prepared();
  void submit(const JobNeeds& needs, const std::vector<PreparedTask>& tasks);
  std::string name_of_job(const std::vector<PreparedTask>& tasks) const;
  bool write_files(const JobDirectory& directory, const std::vector<PreparedTask>& tasks);
  SlurmJob& add_job(const JobDirectory& directory, const std::vector<PreparedTask>& tasks);
  void cancel_unwanted();
  void forget_jobs();
  void publish_view();

  const SlurmSettings settings_;
  const std::filesystem::path runs_directory_, jobs_directory_;
  const Clock& clock_;

  std::vector<PreparedTask> prepared_;
  std::map<RunHandle, PreparedRun> prepared_runs_;
  std::map<RunHandle, Address> addresses_;  ///< of the runs that were submitted
  std::map<std::string, SlurmJob> jobs_;    ///< by name
  std::map<RunHandle, Address> earlier_;    ///< runs of an earlier daemon, before they are adopted
  bool has_found_earlier_jobs_ = false;

  std::size_t cases_a_task_ = 1;
  std::chrono::milliseconds next_question_{0};
  std::chrono::milliseconds hold_until_{0};  ///< no run is started before
  /// Why squeue gave no answer; "". Nothing is started before the first answer.
  std::string unanswered_ = "Slurm was not asked yet";
  std::string refusal_;  ///< why the last sbatch failed; ""
  std::string failure_;  ///< of the last job that failed before its first case; "" once a case was computed
  std::chrono::milliseconds hold_;  ///< after the next such failure

  mutable std::mutex view_mutex_;
  View view_;
};

}  // namespace capstan
