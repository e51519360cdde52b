#include "runner/slurm/job_request.hpp"

#include <algorithm>
#include <cmath>

#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

/// The smallest of unit, 2 unit, 4 unit, .. that is at least `value`.
int rounded_up(double value, int unit) {
  constexpr int kMaxDoublings = 20;
  int rounded = unit;
  for (int i = 0; i < kMaxDoublings && rounded < value; ++i) rounded *= 2;
  return rounded;
}

/// For the shell: in single quotes.
std::string in_quotes(const std::string& text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + "'";
}

}  // namespace

JobNeeds needs_of(double seconds, double bytes, const SlurmSettings& settings) {
  constexpr double kSlowNodes = 4;  // times slower than the machine on which the costs were measured
  constexpr double kSpareMb = 150, kMemoryMargin = 1.5, kSpareMinutes = 3;
  constexpr int kMinMinutes = 10, kMinMb = 256;
  const std::chrono::minutes time(rounded_up(kSlowNodes * seconds / 60 + kSpareMinutes, kMinMinutes));
  const double memory = settings.memory_mb > 0 ? settings.memory_mb : kSpareMb + kMemoryMargin * bytes / 1e6;
  return {settings.memory_mb > 0 ? static_cast<int>(std::ceil(memory)) : rounded_up(memory, kMinMb),
          settings.max_time.count() > 0 ? std::min(time, settings.max_time) : time};
}

/// The shell is replaced by the program, so that Slurm's signals reach it; one that comes before does no
/// harm. It ends together with Slurm's own process on the node (CAPSTAN_DAEMON, parent_daemon.hpp), and its
/// cases end with it. HDF5's locks are switched off, as some network file systems have none, and a run
/// directory has one writer anyway.
void write_job_script(const JobDirectory& job, const SlurmSettings& settings) {
  write_durably(job.script(),
                "#!/bin/sh\n"
                "# Written by `capstan serve`: computes the cases in $SLURM_ARRAY_TASK_ID.list\n"
                "cd " +
                    in_quotes(job.path()) +
                    " || exit\n"
                    "trap '' USR1\n"
                    "export HDF5_USE_FILE_LOCKING=FALSE CAPSTAN_DAEMON=$PPID\n"
                    "exec " +
                    in_quotes(settings.program) +
                    " solve-list \"$SLURM_ARRAY_TASK_ID.list\" --journal \"$SLURM_ARRAY_TASK_ID.journal\"\n");
}

/// Slurm must not repeat a job by itself (--no-requeue): the daemon does that, with a new token.
std::vector<std::string> sbatch_command(const JobDirectory& job, int tasks, const JobNeeds& needs,
                                        const SlurmSettings& settings) {
  std::vector<std::string> words = {"sbatch",
                                    "--parsable",
                                    "--ntasks=1",
                                    "--cpus-per-task=1",
                                    "--mem=" + std::to_string(needs.memory_mb) + "M",
                                    "--time=" + std::to_string(needs.time.count()),
                                    "--signal=B:USR1@120"};
  if (!settings.partition.empty()) words.push_back("--partition=" + settings.partition);
  if (!settings.account.empty()) words.push_back("--account=" + settings.account);
  words.insert(words.end(), settings.extra.begin(), settings.extra.end());
  // Last, as sbatch takes the last of two: a job is found again by them.
  words.insert(words.end(), {"--job-name=" + job.name(), "--array=0-" + std::to_string(tasks - 1),
                             "--output=" + job.log_pattern().string(), "--no-requeue", job.script()});
  return words;
}

}  // namespace capstan
