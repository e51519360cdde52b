#pragma once
// Group commit of submitted studies: those that arrive while the disk is busy are committed together.
//
// A commit waits for the disk. With one commit a study, clients that submit at the same time would wait for
// each other. Here one client at a time, which holds `submitting_`, commits for all that wait.
#include <deque>
#include <exception>
#include <mutex>
#include <string>

#include "runner/daemon/queue_writer.hpp"
#include "runner/daemon/submit_study.hpp"

namespace capstan {

class Submissions {
 public:
  Submissions(QueueWriter& writer, const Clock& clock) : writer_(writer), clock_(clock) {}

  /// Returns once the study is safe on the disk. From any thread, not holding the writer's mutex.
  /// \param key  the Idempotency-Key, or "". Throws KeyReused if the key was sent with another study before.
  Submission submit(const Study& study, const std::string& key);

 private:
  /// One client that waits.
  struct Request {
    const Study& study;
    const std::string& key;
    Submission submission = {};
    std::exception_ptr error = {};
    bool is_answered = false;
  };

  std::deque<Request*> take_waiting();
  void commit_waiting();

  QueueWriter& writer_;
  const Clock& clock_;
  // Order of locking: submitting_, then the writer's mutex, then waiting_mutex_.
  std::mutex submitting_;     ///< held by the client that commits for all
  std::mutex waiting_mutex_;  ///< guards waiting_, for moments only
  std::deque<Request*> waiting_;
};

}  // namespace capstan
