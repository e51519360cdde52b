#pragma once
// What a client is sent that follows a study: server-sent events (WHATWG HTML, 9.2).
#include <optional>
#include <string>

#include "runner/store/clock.hpp"
#include "runner/store/database.hpp"

namespace capstan {

/// Each event is the whole study as it stands, and its id names that state: whoever comes again with the last
/// id that he saw misses nothing that still holds, also of a server that was started again.
class StudyEvents {
 public:
  /// Then the client comes again, and the thread was free for another.
  static constexpr std::chrono::seconds kMax{60};

  StudyEvents(std::string study_id, std::string last_event_id, Time begin)
      : study_id_(std::move(study_id)), last_id_(std::move(last_event_id)), begin_(begin) {}

  /// What is new, maybe nothing; no text at all once the stream is over.
  std::optional<std::string> next(Database& database, Time now);
  /// There is nothing to wait for any more.
  bool is_over() const { return is_over_; }

 private:
  std::string study_id_;
  std::string last_id_;
  Time begin_;
  bool is_over_ = false;
};

}  // namespace capstan
