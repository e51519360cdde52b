#include "runner/slurm/export_cases.hpp"

#include <algorithm>
#include <vector>

#include "runner/slurm/case_list.hpp"
#include "runner/slurm/job_request.hpp"
#include "solver/case/content_id.hpp"
#include "solver/case/run_cost.hpp"
#include "solver/case/run_size.hpp"
#include "solver/run_directory/attempt_token.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

/// The cases of one task, and what they need.
struct ExportedTask {
  std::vector<ListedCase> cases = {};
  double seconds = 0, bytes = 0;
};

/// Makes the run directory of a case.
ListedCase export_case(const Case& c, const std::filesystem::path& directory) {
  const auto [id, document] = canonical(c);
  const RunDirectory run(directory / "runs" / id);
  const std::string token = new_token();
  run.prepare(document);
  run.begin_attempt(token);
  return {token, id, RunDirectory(std::filesystem::path("runs") / id)};
}

/// Each task gets every N-th case: neighbours in a study cost about the same, so all tasks take about as
/// long.
std::vector<ExportedTask> export_tasks(const Study& study, const std::filesystem::path& directory,
                                       std::size_t jobs) {
  std::vector<ExportedTask> tasks(std::min(jobs, study.cases.size()));
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    ExportedTask& task = tasks[i % tasks.size()];
    task.cases.push_back(export_case(study.cases[i], directory));
    task.seconds += case_cost(study.cases[i]);
    task.bytes = std::max(task.bytes, run_memory(study.cases[i]));
  }
  return tasks;
}

JobNeeds largest_needs(const std::vector<ExportedTask>& tasks) {
  JobNeeds largest;
  for (const ExportedTask& task : tasks) {
    const JobNeeds needs = needs_of(task.seconds, task.bytes, {});
    largest = {std::max(largest.memory_mb, needs.memory_mb), std::max(largest.time, needs.time)};
  }
  return largest;
}

/// Two minutes before the time limit the present case writes a checkpoint; the job is then put back into
/// Slurm's queue, and goes on from there.
std::string script_of(const std::string& name, std::size_t tasks, const JobNeeds& needs,
                      const std::filesystem::path& program) {
  return "#!/bin/sh\n"
         "# Computes the cases of " +
         name +
         ": cd to this directory, then sbatch job.sh\n"
         "# What is computed is kept; cases without a result are computed when the job is submitted again.\n"
         "#SBATCH --job-name=capstan-" +
         name +
         "\n"
         "#SBATCH --array=0-" +
         std::to_string(tasks - 1) +
         "\n"
         "#SBATCH --ntasks=1 --cpus-per-task=1\n"
         "#SBATCH --mem=" +
         std::to_string(needs.memory_mb) +
         "M\n"
         "#SBATCH --time=" +
         std::to_string(needs.time.count()) +
         "\n"
         "#SBATCH --signal=B:USR1@120 --requeue\n"
         "#SBATCH --output=%a.log --open-mode=append\n"
         "capstan=${CAPSTAN:-" +
         program.string() +
         "}\n"
         "task=$SLURM_ARRAY_TASK_ID\n"
         "export HDF5_USE_FILE_LOCKING=FALSE CAPSTAN_DAEMON=$$\n"
         "list=\n"
         "trap '[ -z \"$list\" ] || kill -USR1 \"$list\"' USR1\n"
         "\"$capstan\" solve-list \"$task.list\" --journal \"$task.journal\" &\n"
         "list=$!\n"
         "code=0\n"
         "wait \"$list\" || code=$?\n"
         "if [ \"$code\" -gt 128 ]; then  # the signal ended the wait, not the list\n"
         "  code=0\n"
         "  wait \"$list\" || code=$?\n"
         "fi\n"
         "if [ \"$code\" = 75 ]; then scontrol requeue \"${SLURM_ARRAY_JOB_ID}_$task\"; fi\n"
         "exit \"$code\"\n";
}

}  // namespace

std::size_t export_cases(const Study& study, const std::filesystem::path& directory, std::size_t jobs,
                         const std::filesystem::path& program) {
  const std::vector<ExportedTask> tasks = export_tasks(study, directory, jobs);
  for (std::size_t i = 0; i < tasks.size(); ++i)
    write_case_list(directory / (std::to_string(i) + ".list"), tasks[i].cases);
  write_durably(directory / kExportedStudy, study.document.dump(2) + "\n");
  write_durably(directory / "job.sh", script_of(study.name, tasks.size(), largest_needs(tasks), program));
  return tasks.size();
}

}  // namespace capstan
