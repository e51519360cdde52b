#pragma once
// Runs a command of Slurm (sbatch, squeue, scancel) and collects what it prints.
#include <chrono>
#include <string>
#include <vector>

namespace capstan {

struct CommandOutcome {
  bool is_finished = false;  ///< false: it could not be started, or took too long and was killed
  int exit_code = -1;
  std::string output = {};  ///< standard output
  std::string errors = {};  ///< standard error, or why it is not finished

  bool is_success() const { return is_finished && exit_code == 0; }
};

/// \param words  the program, looked up in PATH, and its arguments
CommandOutcome run_command(const std::vector<std::string>& words, std::chrono::milliseconds max_time);

}  // namespace capstan
