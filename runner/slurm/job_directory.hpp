#pragma once
// The files of one job array: DATA/jobs/NAME. Its name is the job's name in Slurm.
#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

class JobDirectory {
 public:
  explicit JobDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }
  std::string name() const { return path_.filename(); }
  std::filesystem::path script() const { return path_ / "job.sh"; }
  /// The cases of a task (case_list.hpp).
  std::filesystem::path list(int task) const { return of_task(task, ".list"); }
  std::filesystem::path journal(int task) const { return of_task(task, ".journal"); }
  /// Standard output and error of the job.
  std::filesystem::path log(int task) const { return of_task(task, ".log"); }
  /// The same for all tasks, as sbatch --output takes it.
  std::filesystem::path log_pattern() const { return path_ / "%a.log"; }

  /// The tasks that have a list, in their order.
  std::vector<int> tasks() const;

 private:
  std::filesystem::path of_task(int task, const char* extension) const {
    return path_ / (std::to_string(task) + extension);
  }

  std::filesystem::path path_;
};

}  // namespace capstan
