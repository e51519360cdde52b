#pragma once
// One job array and the runs of its tasks, as far as Slurm and the journals tell.
#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runner/slurm/case_list.hpp"
#include "runner/slurm/job_directory.hpp"
#include "runner/slurm/listed_task.hpp"

namespace capstan {

/// The run of one case in a task.
struct SlurmRun {
  ListedCase listed;
  bool has_begun = false;
  std::optional<ProcessEnd> end = {};
};

struct SlurmTask {
  std::vector<SlurmRun> runs;
  std::optional<ListedTask> listed = {};  ///< what squeue said last
  int looks_after_end = 0;                ///< in succession, in which the task was not active
  bool is_unwanted = false;               ///< its job is to be cancelled

  bool has_open_runs() const;
};

/// What squeue printed: tasks by job and index.
using ListedTasks = std::map<std::pair<std::string, int>, ListedTask>;

class SlurmJob {
 public:
  explicit SlurmJob(JobDirectory directory) : directory_(std::move(directory)) {}

  const JobDirectory& directory() const { return directory_; }
  std::map<int, SlurmTask>& tasks() { return tasks_; }
  const std::map<int, SlurmTask>& tasks() const { return tasks_; }

  /// sbatch was called and has ended at this time. It may have failed and still have submitted the job.
  /// \param refusal  what it said if it failed; "" if it said that the job was taken
  void submitted(std::chrono::milliseconds at, const std::string& refusal);

  /// Judges the tasks by an answer of squeue. A task that Slurm does not list any more, or lists as ended,
  /// counts as ended at the second such answer, as the files of a node may appear late on a network file
  /// system.
  /// \param asked  when squeue was started; a job that was submitted later is not judged
  void look(const ListedTasks& listed, std::chrono::milliseconds asked);

  /// True if no task is waiting or running in Slurm.
  bool has_ended() const;

 private:
  void read_notes(int index, SlurmTask& task);
  void conclude(int index, SlurmTask& task) const;
  ProcessEnd end_of(const SlurmRun& run, int index, const SlurmTask& task) const;

  JobDirectory directory_;
  std::map<int, SlurmTask> tasks_;
  std::chrono::milliseconds submitted_{0};
  bool is_taken_ = false;  ///< Slurm knows or knew the job
  std::string refusal_;
};

}  // namespace capstan
