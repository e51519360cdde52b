#pragma once
// The server-sent events of a study (WHATWG HTML, 9.2), for clients that follow its progress.
#include <optional>
#include <string>

#include "runner/store/clock.hpp"
#include "runner/store/database.hpp"

namespace capstan {

/// Each event carries the whole study, and the id of the event is a digest of it. A client that reconnects
/// names the last id that it has seen; it is sent the present study only if that has another digest. This
/// works also after a restart of the server.
class StudyEvents {
 public:
  /// Max duration of a stream. The client then reconnects; meanwhile another client can have the thread.
  static constexpr std::chrono::seconds kMax{60};

  StudyEvents(std::string study_id, std::string last_event_id, Time begin)
      : study_id_(std::move(study_id)), last_id_(std::move(last_event_id)), begin_(begin) {}

  /// The next part of the stream, empty if the study has not changed; nothing after the end of the stream.
  std::optional<std::string> next(Database& database, Time now);
  /// True once next() has returned the last part.
  bool is_over() const { return is_over_; }

 private:
  std::string study_id_;
  std::string last_id_;
  Time begin_;
  bool is_over_ = false;
};

}  // namespace capstan
