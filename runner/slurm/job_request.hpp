#pragma once
// What is asked of Slurm for a job array, and the script that its tasks run.
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "runner/slurm/job_directory.hpp"

namespace capstan {

struct SlurmSettings {
  std::filesystem::path program = {};  ///< capstan; on a path that the nodes see, too
  std::size_t jobs = 100;              ///< tasks of job arrays that wait or run at the same time, at most
  std::string partition = {}, account = {};  ///< "": Slurm's default
  std::chrono::minutes max_time{0};          ///< the longest time to ask for; 0: no limit
  double memory_mb = 0;                      ///< to ask for; 0: by the estimated memory of the cases
  std::vector<std::string> extra = {};       ///< further arguments of sbatch
};

/// What one task asks for.
struct JobNeeds {
  int memory_mb = 0;
  std::chrono::minutes time{0};
  auto operator<=>(const JobNeeds&) const = default;
};

/// Estimated needs, with a margin, rounded up to a few values, so that tasks which are much alike share an
/// array. A case that takes longer writes a checkpoint in time and is resumed by another job.
/// \param seconds  on one core, of all cases of the task
/// \param bytes    of the largest case
JobNeeds needs_of(double seconds, double bytes, const SlurmSettings& settings);

/// Writes the script that each task of the array runs.
void write_job_script(const JobDirectory& job, const SlurmSettings& settings);

/// The words of the command that submits the array.
std::vector<std::string> sbatch_command(const JobDirectory& job, int tasks, const JobNeeds& needs,
                                        const SlurmSettings& settings);

}  // namespace capstan
