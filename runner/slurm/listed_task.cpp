#include "runner/slurm/listed_task.hpp"

#include <array>
#include <charconv>
#include <set>

namespace capstan {
namespace {

constexpr std::size_t kFields = 6;

/// The last field may contain the separator, as it is the name of any job of this user.
std::optional<std::array<std::string_view, kFields>> fields_of(std::string_view line) {
  std::array<std::string_view, kFields> fields;
  for (std::size_t i = 0; i + 1 < kFields; ++i) {
    const std::size_t end = line.find('|');
    if (end == std::string_view::npos) return std::nullopt;
    fields[i] = line.substr(0, end);
    line.remove_prefix(end + 1);
  }
  fields.back() = line;
  return fields;
}

/// The index of a task; nothing for "N/A", a job that is no array, or a range of tasks that wait.
std::optional<int> index_in(std::string_view text) {
  int index = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), index);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return index;
}

}  // namespace

bool ListedTask::is_active() const {
  static const std::set<std::string> kEnded = {"BOOT_FAIL", "CANCELLED", "COMPLETED", "DEADLINE",
                                               "FAILED",    "NODE_FAIL", "PREEMPTED", "OUT_OF_MEMORY",
                                               "REVOKED",   "TIMEOUT"};
  return !kEnded.contains(state);
}

/// --array prints a line for each task. Without --states=all, tasks that have ended are left out.
std::vector<std::string> squeue_command() {
  return {"squeue", "--noheader", "--array", "--me", "--states=all", "--format=%i|%K|%T|%r|%N|%j"};
}

std::optional<std::vector<ListedTask>> parse_squeue(std::string_view output) {
  std::vector<ListedTask> tasks;
  while (!output.empty()) {
    const std::string_view line = output.substr(0, output.find('\n'));
    output.remove_prefix(std::min(line.size() + 1, output.size()));
    const auto fields = fields_of(line);
    if (!fields) return std::nullopt;
    const auto& [id, index, state, reason, node, name] = *fields;
    const std::optional<int> task = index_in(index);
    if (!task || !name.starts_with(kJobPrefix)) continue;
    tasks.push_back({std::string(name), *task, std::string(id), std::string(state), std::string(reason),
                     std::string(node)});
  }
  return tasks;
}

}  // namespace capstan
