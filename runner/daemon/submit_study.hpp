#pragma once
// A submitted study becomes rows of the database.
#include <stdexcept>
#include <string>

#include "runner/store/clock.hpp"
#include "runner/store/database.hpp"
#include "runner/study/study.hpp"

namespace capstan {

struct Submission {
  std::string study_id;
  bool is_new = false;
  bool is_resumed = false;  ///< the study was paused
};

/// A client sent two different studies under one key.
class KeyReused : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Stores the study and queues its cases; a case that another study contains is shared with it. A study that
/// is known is not stored again: its cancelled cases are queued again, and if it was paused it is resumed.
/// \param key  Idempotency-Key of the request, or "". A request that is repeated with its key does not resume
///             the study. Throws KeyReused if the key was sent with another study before.
Submission submit_study(Database& database, const Clock& clock, const Study& study,
                        const std::string& key = "");

}  // namespace capstan
