#include "runner/slurm/slurm_job.hpp"

#include <algorithm>

#include "runner/slurm/slurm_words.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

/// The end of a log, at most.
std::string tail_of(const std::filesystem::path& file) {
  constexpr std::size_t kMax = 500;
  std::string text = read_file(file).value_or("");
  while (text.ends_with('\n')) text.pop_back();
  return text.size() > kMax ? text.substr(text.size() - kMax) : text;
}

bool is_crash(const std::string& state) { return state == "FAILED" || state == "OUT_OF_MEMORY"; }

}  // namespace

bool SlurmTask::has_open_runs() const {
  return std::any_of(runs.begin(), runs.end(), [](const SlurmRun& run) { return !run.end; });
}

void SlurmJob::submitted(std::chrono::milliseconds at, const std::string& refusal) {
  submitted_ = at;
  refusal_ = refusal;
  is_taken_ = refusal.empty();
}

void SlurmJob::look(const ListedTasks& listed, std::chrono::milliseconds asked) {
  if (asked < submitted_) return;
  for (auto& [index, task] : tasks_) {
    const auto found = listed.find({directory_.name(), index});
    const bool is_listed = found != listed.end();
    if (is_listed) task.listed = found->second;
    is_taken_ = is_taken_ || is_listed;
    const bool is_active = is_listed && found->second.is_active();
    task.looks_after_end = is_active ? 0 : task.looks_after_end + 1;
    if (!task.has_open_runs()) continue;
    if (!is_active || !found->second.is_waiting()) read_notes(index, task);
    if (!is_listed) task.listed.reset();
    if (task.looks_after_end >= 2) conclude(index, task);
  }
}

bool SlurmJob::has_ended() const {
  return std::all_of(tasks_.begin(), tasks_.end(),
                     [](const auto& entry) { return entry.second.looks_after_end > 0; });
}

void SlurmJob::read_notes(int index, SlurmTask& task) {
  const std::map<std::string, NotedRun> notes = read_journal(directory_.journal(index));
  for (SlurmRun& run : task.runs) {
    const auto noted = notes.find(run.listed.token);
    if (run.end || noted == notes.end()) continue;
    run.has_begun = true;
    run.end = noted->second.end;
  }
}

/// Should a process of the task still be alive, it publishes nothing from now on.
void SlurmJob::conclude(int index, SlurmTask& task) const {
  for (SlurmRun& run : task.runs) {
    if (run.end) continue;
    run.listed.directory.withdraw_attempt();
    run.end = end_of(run, index, task);
  }
}

ProcessEnd SlurmJob::end_of(const SlurmRun& run, int index, const SlurmTask& task) const {
  const std::string how = !is_taken_     ? "Slurm did not take its job: " + refusal_
                          : !task.listed ? "Slurm does not know its job any more"
                                         : how_it_ended(*task.listed);
  if (!run.has_begun) {
    const std::string log = tail_of(directory_.log(index));
    return {ProcessEnd::How::not_begun, 0, log.empty() ? how : how + ": " + log};
  }
  if (task.listed && is_crash(task.listed->state)) return {ProcessEnd::How::exited, kExitError, how};
  return {ProcessEnd::How::lost, 0, how};
}

}  // namespace capstan
