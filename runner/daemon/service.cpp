#include "runner/daemon/service.hpp"

#include "runner/daemon/replacement.hpp"
#include "runner/daemon/take_over.hpp"

namespace capstan {

Service::Service(const DataDirectory& data, Executor& executor, const Clock& clock, RunLimits limits,
                 std::chrono::milliseconds lease)
    : data_(data),
      executor_(executor),
      free_space_(data.runs()),
      writer_(data.database(), clock, lease),
      readers_(data.database(), writer_.database),
      submissions_(writer_, clock),
      scheduler_(writer_, executor, clock, data, free_space_, limits) {
  for (const Claim& claim : take_over(writer_, executor, data)) scheduler_.supervise_run(claim);
}

Submission Service::submit(const Study& study, const std::string& key) {
  Submission submission = submissions_.submit(study, key);
  changed_();
  return submission;
}

std::optional<int> Service::change(const std::function<std::optional<int>(JobQueue&)>& action) {
  const std::lock_guard lock(writer_.mutex);
  writer_.expect_sound();
  const std::optional<int> cases = action(writer_.queue);
  changed_();
  return cases;
}

std::optional<int> Service::cancel(const std::string& study_id) {
  return change([&](JobQueue& queue) { return queue.cancel(study_id); });
}

std::optional<int> Service::set_priority(const std::string& study_id, int priority) {
  return change([&](JobQueue& queue) { return queue.set_priority(study_id, priority); });
}

std::optional<int> Service::pause(const std::string& study_id, bool is_paused) {
  return change([&](JobQueue& queue) { return queue.pause(study_id, is_paused); });
}

std::optional<int> Service::retry(const std::string& study_id) {
  return change([&](JobQueue& queue) { return queue.retry(study_id); });
}

std::optional<Deletion> Service::remove(const std::string& study_id) {
  std::optional<Deletion> deletion;
  change([&](JobQueue& queue) {
    deletion = delete_study(writer_.database, queue, study_id);
    return deletion ? std::optional<int>(deletion->deleted) : std::nullopt;
  });
  return deletion;
}

Issues Service::retry_at(const std::string& study_id, const nlohmann::json& fidelity) {
  Issues issues;
  change([&](JobQueue&) -> std::optional<int> {
    issues = replace_failed(writer_.database, study_id, fidelity);
    return std::nullopt;
  });
  return issues;
}

std::string Service::why_nothing_starts() const {
  const std::string shortage = free_space_.shortage();
  return shortage.empty() ? executor_.obstacle() : shortage;
}

RunPlaces Service::places() const {
  return {executor_.slots(), executor_.slot_name(), why_nothing_starts(),
          [this](const std::string& handle) { return executor_.place(handle); }};
}

void Service::tick() {
  if (!scheduler_.has_left_runs()) executor_.exchange();
  const std::lock_guard lock(writer_.mutex);
  scheduler_.tick();
}

}  // namespace capstan
