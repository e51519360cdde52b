#include "runner/daemon/submissions.hpp"

#include "runner/store/fail_point.hpp"

namespace capstan {

Submission Submissions::submit(const Study& study, const std::string& key) {
  Request request{study, key};
  {
    const std::lock_guard lock(waiting_mutex_);
    waiting_.push_back(&request);
  }
  {
    const std::lock_guard alone(submitting_);
    while (!request.is_answered) {
      const std::lock_guard lock(writer_.mutex);
      commit_waiting();
    }
  }
  if (request.error) std::rethrow_exception(request.error);
  return request.submission;
}

/// Takes the oldest requests from the queue. Their number of cases is limited, because the loop waits for the
/// writer's mutex while they are committed.
std::deque<Submissions::Request*> Submissions::take_waiting() {
  constexpr std::size_t kMaxCasesAtOnce = 5000;
  std::deque<Request*> taken;
  const std::lock_guard lock(waiting_mutex_);
  for (std::size_t cases = 0; !waiting_.empty() && cases < kMaxCasesAtOnce; waiting_.pop_front()) {
    taken.push_back(waiting_.front());
    cases += waiting_.front()->study.cases.size();
  }
  return taken;
}

/// One transaction for all. A reused key fails its own request alone; any other error fails all of them.
void Submissions::commit_waiting() {
  const std::deque<Request*> together = take_waiting();
  std::exception_ptr error;
  try {
    writer_.expect_sound();
    Transaction transaction(writer_.database);
    for (Request* request : together) try {
        request->submission = submit_study(writer_.database, clock_, request->study, request->key);
      } catch (const KeyReused&) {  // thrown before anything was changed
        request->error = std::current_exception();
      }
    transaction.commit();
    fail_point("submitted");
  } catch (...) {
    error = std::current_exception();
  }
  for (Request* request : together) {
    if (error) request->error = error;
    request->is_answered = true;
  }
}

}  // namespace capstan
