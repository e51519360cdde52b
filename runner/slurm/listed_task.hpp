#pragma once
// What squeue says of the tasks of job arrays.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

/// Begins the names of all jobs of Capstan.
inline constexpr std::string_view kJobPrefix = "capstan-";

/// One task of a job array that Slurm knows. It remembers tasks that have ended for some minutes.
struct ListedTask {
  std::string job = {};     ///< name of the array
  int task = 0;             ///< index in the array
  std::string id = {};      ///< Slurm's number for people: "17_3"
  std::string state = {};   ///< "PENDING", "RUNNING", "COMPLETED" …
  std::string reason = {};  ///< why it is pending, or why it ended: "Priority", "NodeDown" …
  std::string node = {};    ///< "" while it is pending

  bool is_waiting() const { return state == "PENDING"; }
  /// Whether it waits, runs, or is being cleaned up.
  bool is_active() const;
};

/// The words of the command that lists all tasks of this user.
std::vector<std::string> squeue_command();

/// Capstan's tasks in the output of that command. Nothing if a line has not the expected form: then no line
/// is to be trusted.
std::optional<std::vector<ListedTask>> parse_squeue(std::string_view output);

}  // namespace capstan
