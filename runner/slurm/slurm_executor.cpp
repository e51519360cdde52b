#include "runner/slurm/slurm_executor.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "runner/queries/metrics.hpp"
#include "runner/slurm/run_command.hpp"
#include "runner/slurm/slurm_words.hpp"
#include "solver/case/parse.hpp"
#include "solver/case/run_cost.hpp"
#include "solver/case/run_size.hpp"

namespace capstan {
namespace {

using namespace std::chrono_literals;
using std::chrono::milliseconds;

constexpr milliseconds kMaxCommandTime = 30s;

/// Time between two calls of squeue: fifty times as long as the last one took, so that a busy controller is
/// asked less often.
constexpr milliseconds kMinInterval = 2s, kMaxInterval = 60s;
constexpr milliseconds kIntervalWithoutAnswer = 10s;
constexpr int kIntervalsACall = 50;

/// After a job that was refused or that failed before its first case; twice as long after each failure that
/// follows.
constexpr milliseconds kHold = 10s, kMaxHold = 10min;

/// Short cases share a task until it is expected to take so long.
constexpr double kTaskSeconds = 600;
constexpr std::size_t kMaxCasesATask = 100;
constexpr std::size_t kMaxTasksAJob = 1000;  // Slurm's default MaxArraySize is 1001

RunHandle handle_of(const std::string& token) { return "slurm:" + token; }

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string error_of(const CommandOutcome& result) {
  const std::string line = first_line(result.errors);
  return line.empty() ? "exit code " + std::to_string(result.exit_code) : line;
}

ListedTasks by_name(std::vector<ListedTask> tasks) {
  ListedTasks all;
  for (ListedTask& task : tasks) {
    const std::pair key(task.job, task.task);
    all.insert_or_assign(key, std::move(task));
  }
  return all;
}

/// Without the characters that have a meaning in a label.
std::string printable_label(std::string text) {
  std::erase_if(text, [](char c) { return c == '"' || c == '\\' || c == '\n'; });
  return text;
}

RunPlace place_in(const SlurmTask& task, bool has_begun = false) {
  if (!task.listed) return {true, "handed over to Slurm", "handed over to Slurm"};
  const ListedTask& listed = *task.listed;
  if (listed.is_waiting()) {
    const std::string words = "in Slurm's queue: " + why_it_waits(listed);
    return {true, "waiting " + words, "waits as job " + listed.id + " " + words};
  }
  if (!listed.is_active()) return {true, "its job has ended", how_it_ended(listed)};
  const std::string node = listed.node.empty() ? "" : " on node " + listed.node;
  if (!has_begun)
    return {true, "waiting in a job" + node + " for its turn",
            "waits in Slurm's job " + listed.id + node + " for its turn"};
  return {false, "running" + node, "Slurm's job " + listed.id + node};
}

}  // namespace

SlurmExecutor::SlurmExecutor(SlurmSettings settings, const std::filesystem::path& runs, const Clock& clock)
    : settings_(std::move(settings)),
      runs_directory_(std::filesystem::canonical(runs)),
      jobs_directory_(runs_directory_ / "jobs"),
      clock_(clock),
      hold_(kHold) {}

bool SlurmExecutor::is_full(const PreparedTask& task) const {
  return task.runs.size() >= cases_a_task_ || task.seconds >= kTaskSeconds;
}

std::size_t SlurmExecutor::open_tasks() const {
  std::size_t open = 0;
  for (const auto& [name, job] : jobs_)
    for (const auto& [index, task] : job.tasks()) open += task.has_open_runs() ? 1 : 0;
  return open;
}

/// Half of the waiting cases are shared out among all tasks, so that those which end early find more.
bool SlurmExecutor::has_room(std::size_t /*runs*/, std::size_t waiting) {
  cases_a_task_ = std::clamp<std::size_t>(waiting / (2 * settings_.jobs), 1, kMaxCasesATask);
  if (!unanswered_.empty() || clock_.elapsed() < hold_until_) return false;
  return open_tasks() + prepared_.size() < settings_.jobs ||
         (!prepared_.empty() && !is_full(prepared_.back()));
}

RunHandle SlurmExecutor::start(const Claim& claim, const RunDirectory& directory) {
  const ParsedCase parsed = parse_case(nlohmann::json::parse(claim.document));
  if (prepared_.empty() || is_full(prepared_.back())) prepared_.emplace_back();
  PreparedTask& task = prepared_.back();
  if (parsed.value) {
    task.seconds += case_cost(*parsed.value);
    task.bytes = std::max(task.bytes, run_memory(*parsed.value));
  }
  const RunHandle handle = handle_of(claim.token);
  task.runs.push_back(handle);
  const RunDirectory seen_by_nodes(runs_directory_ / directory.path().filename());
  prepared_runs_.insert({handle, {{claim.token, claim.case_id, seen_by_nodes}, claim.attempt}});
  return handle;
}

/// Reads the lists of the jobs that an earlier daemon submitted, or was about to submit. A job is unwanted
/// unless one of its runs is adopted.
void SlurmExecutor::find_earlier_jobs() {
  if (std::exchange(has_found_earlier_jobs_, true) || !std::filesystem::exists(jobs_directory_)) return;
  for (const auto& entry : std::filesystem::directory_iterator(jobs_directory_)) {
    const JobDirectory directory(entry.path());
    SlurmJob& job = jobs_.try_emplace(directory.name(), directory).first->second;
    job.submitted(clock_.elapsed(), "the daemon ended before Slurm answered");
    for (const int index : directory.tasks())
      for (const ListedCase& listed : read_case_list(directory.list(index))) {
        SlurmTask& task = job.tasks()[index];
        task.is_unwanted = true;
        earlier_[handle_of(listed.token)] = {directory.name(), index, task.runs.size()};
        task.runs.push_back({listed, false, ProcessEnd{}});
      }
  }
}

bool SlurmExecutor::adopt(const Claim& claim, const RunDirectory& /*directory*/) {
  find_earlier_jobs();
  const auto found = earlier_.find(claim.handle);
  if (found == earlier_.end()) return false;
  addresses_.insert(*found);
  find(claim.handle)->end.reset();
  jobs_.at(found->second.job).tasks().at(found->second.task).is_unwanted = false;
  return true;
}

SlurmRun* SlurmExecutor::find(const RunHandle& run) {
  const auto found = addresses_.find(run);
  if (found == addresses_.end()) return nullptr;
  const auto& [job, task, position] = found->second;
  return &jobs_.at(job).tasks().at(task).runs.at(position);
}

std::optional<ProcessEnd> SlurmExecutor::poll(const RunHandle& handle) {
  if (const auto prepared = prepared_runs_.find(handle); prepared != prepared_runs_.end()) {
    const std::optional<ProcessEnd> end = prepared->second.end;
    if (end) prepared_runs_.erase(prepared);
    return end;
  }
  const SlurmRun* run = find(handle);
  if (!run) return ProcessEnd{};
  const std::optional<ProcessEnd> end = run->end;
  if (end) {
    const Address& address = addresses_.at(handle);
    learn_from(*end, jobs_.at(address.job).tasks().at(address.task));
    addresses_.erase(handle);
  }
  return end;
}

/// A cluster on whose nodes no case begins, as the program is missing there, is not flooded with jobs. Runs
/// that fail together count once.
void SlurmExecutor::learn_from(const ProcessEnd& end, const SlurmTask& task) {
  if (end.how == ProcessEnd::How::exited || end.how == ProcessEnd::How::signalled) {
    failure_.clear();
    hold_ = kHold;
  }
  if (end.how != ProcessEnd::How::not_begun || !task.listed || task.listed->state != "FAILED") return;
  failure_ = end.reason;
  if (clock_.elapsed() < hold_until_) return;
  hold_until_ = clock_.elapsed() + hold_;
  hold_ = std::min(2 * hold_, kMaxHold);
}

void SlurmExecutor::cancel(const RunHandle& handle, StopBy /*stop*/) {
  const ProcessEnd stopped{ProcessEnd::How::lost, 0, "it was stopped"};
  if (const auto prepared = prepared_runs_.find(handle); prepared != prepared_runs_.end())
    prepared->second.end = stopped;
  SlurmRun* run = find(handle);
  if (!run || run->end) return;
  run->listed.directory.withdraw_attempt();
  run->end = stopped;
  const Address& address = addresses_.at(handle);
  SlurmTask& task = jobs_.at(address.job).tasks().at(address.task);
  task.is_unwanted = !task.has_open_runs();
}

void SlurmExecutor::exchange() {
  if (is_time_to_ask()) ask();
  submit_prepared();
  publish_view();
}

bool SlurmExecutor::is_time_to_ask() const {
  return (!jobs_.empty() || !unanswered_.empty()) && clock_.elapsed() >= next_question_;
}

void SlurmExecutor::ask() {
  const milliseconds asked = clock_.elapsed();
  const CommandOutcome result = run_command(squeue_command(), kMaxCommandTime);
  const milliseconds now = clock_.elapsed();
  next_question_ = now + std::clamp(kIntervalsACall * (now - asked), kMinInterval, kMaxInterval);
  const auto listed = result.is_success() ? parse_squeue(result.output) : std::nullopt;
  if (!listed) {
    next_question_ = now + kIntervalWithoutAnswer;
    unanswered_ = "Slurm does not answer (" +
                  (result.is_success() ? "squeue printed: " + first_line(result.output) : error_of(result)) +
                  ")";
    return;
  }
  unanswered_.clear();
  const ListedTasks tasks = by_name(*listed);
  for (auto& [name, job] : jobs_) job.look(tasks, asked);
  cancel_unwanted();
  forget_jobs();
}

/// Tasks with equal needs share an array. Runs that were cancelled meanwhile are left out.
void SlurmExecutor::submit_prepared() {
  std::map<JobNeeds, std::vector<std::vector<PreparedTask>>> arrays;
  for (PreparedTask& task : prepared_) {
    std::erase_if(task.runs, [this](const RunHandle& handle) {
      const auto run = prepared_runs_.find(handle);
      return run == prepared_runs_.end() || run->second.end;
    });
    if (task.runs.empty()) continue;
    std::vector<std::vector<PreparedTask>>& alike = arrays[needs_of(task.seconds, task.bytes, settings_)];
    if (alike.empty() || alike.back().size() == kMaxTasksAJob) alike.emplace_back();
    alike.back().push_back(std::move(task));
  }
  prepared_.clear();
  for (const auto& [needs, alike] : arrays)
    for (const std::vector<PreparedTask>& tasks : alike) submit(needs, tasks);
}

void SlurmExecutor::submit(const JobNeeds& needs, const std::vector<PreparedTask>& tasks) {
  const JobDirectory directory(jobs_directory_ / name_of_job(tasks));
  if (!write_files(directory, tasks)) return;
  SlurmJob& job = add_job(directory, tasks);
  const CommandOutcome result = run_command(
      sbatch_command(directory, static_cast<int>(tasks.size()), needs, settings_), kMaxCommandTime);
  refusal_ = result.is_success() ? "" : error_of(result);
  if (!refusal_.empty()) hold_until_ = clock_.elapsed() + kHold;
  job.submitted(clock_.elapsed(), refusal_);
  next_question_ = std::min(next_question_, clock_.elapsed() + kMinInterval);
}

/// Unique: the id, the attempt and the token of the first run.
std::string SlurmExecutor::name_of_job(const std::vector<PreparedTask>& tasks) const {
  const PreparedRun& first = prepared_runs_.at(tasks.front().runs.front());
  return std::string(kJobPrefix) + first.listed.case_id + "-" + std::to_string(first.attempt) + "-" +
         first.listed.token;
}

/// False if that failed: then the runs have not begun.
bool SlurmExecutor::write_files(const JobDirectory& directory, const std::vector<PreparedTask>& tasks) try {
  std::filesystem::create_directories(directory.path());
  for (std::size_t index = 0; index < tasks.size(); ++index) {
    std::vector<ListedCase> list;
    for (const RunHandle& handle : tasks[index].runs) list.push_back(prepared_runs_.at(handle).listed);
    write_case_list(directory.list(static_cast<int>(index)), list);
  }
  write_job_script(directory, settings_);
  return true;
} catch (const std::filesystem::filesystem_error& error) {
  hold_until_ = clock_.elapsed() + kHold;
  for (const PreparedTask& task : tasks)
    for (const RunHandle& handle : task.runs)
      prepared_runs_.at(handle).end = ProcessEnd{ProcessEnd::How::not_begun, 0, error.what()};
  return false;
}

SlurmJob& SlurmExecutor::add_job(const JobDirectory& directory, const std::vector<PreparedTask>& tasks) {
  SlurmJob& job = jobs_.try_emplace(directory.name(), directory).first->second;
  for (std::size_t index = 0; index < tasks.size(); ++index) {
    SlurmTask& task = job.tasks()[static_cast<int>(index)];
    for (const RunHandle& handle : tasks[index].runs) {
      addresses_[handle] = {directory.name(), static_cast<int>(index), task.runs.size()};
      task.runs.push_back({prepared_runs_.at(handle).listed});
      prepared_runs_.erase(handle);
    }
  }
  return job;
}

void SlurmExecutor::cancel_unwanted() {
  std::vector<std::string> words = {"scancel"};
  for (const auto& [name, job] : jobs_)
    for (const auto& [index, task] : job.tasks())
      if (task.is_unwanted && task.listed && task.listed->is_active()) words.push_back(task.listed->id);
  if (words.size() > 1) run_command(words, kMaxCommandTime);
}

/// Removes the files of the jobs that have no run left, and that Slurm has ended.
void SlurmExecutor::forget_jobs() {
  std::set<std::string> with_runs;
  for (const auto& [handle, address] : addresses_) with_runs.insert(address.job);
  std::erase_if(jobs_, [&](const auto& entry) {
    const auto& [name, job] = entry;
    if (with_runs.contains(name) || !job.has_ended()) return false;
    std::error_code ignored;  // what is left takes only space
    std::filesystem::remove_all(job.directory().path(), ignored);
    return true;
  });
}

void SlurmExecutor::publish_view() {
  View view;
  for (const auto& [handle, run] : prepared_runs_) view.places[handle] = place_in({});
  for (const auto& [handle, address] : addresses_) {
    const SlurmTask& task = jobs_.at(address.job).tasks().at(address.task);
    view.places[handle] = place_in(task, task.runs.at(address.position).has_begun);
  }
  for (const auto& [name, job] : jobs_)
    for (const auto& [index, task] : job.tasks())
      if (task.has_open_runs())
        ++view.tasks[task.listed ? std::pair(task.listed->state, task.listed->reason) : std::pair("", "")];
  view.is_answering = unanswered_.empty();
  view.obstacle = !unanswered_.empty() ? unanswered_
                  : !refusal_.empty()  ? "Slurm took no job at the last try: " + refusal_
                  : !failure_.empty()  ? "jobs fail before their first case: " + failure_
                                       : "";
  const std::lock_guard lock(view_mutex_);
  view_ = std::move(view);
}

/// A run that was started since the last exchange is about to be handed over.
RunPlace SlurmExecutor::place(const RunHandle& run) const {
  const std::lock_guard lock(view_mutex_);
  const auto found = view_.places.find(run);
  return found == view_.places.end() ? place_in({}) : found->second;
}

std::string SlurmExecutor::obstacle() const {
  const std::lock_guard lock(view_mutex_);
  return view_.obstacle;
}

std::string SlurmExecutor::metrics() const {
  const std::lock_guard lock(view_mutex_);
  std::string text = metric_description("capstan_slurm_up", "gauge", "Whether Slurm answered the last time.");
  text += std::string("capstan_slurm_up ") + (view_.is_answering ? "1" : "0") + "\n";
  text += metric_description("capstan_slurm_jobs", "gauge", "Jobs by Slurm's state and reason.");
  for (const auto& [words, count] : view_.tasks)
    text += "capstan_slurm_jobs{state=\"" + printable_label(words.first) + "\",reason=\"" +
            printable_label(words.second) + "\"} " + std::to_string(count) + "\n";
  return text;
}

}  // namespace capstan
