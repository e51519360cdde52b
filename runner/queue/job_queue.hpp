#pragma once
// The queue's whole vocabulary. A case is executed at least once and its result is recorded exactly once:
//
//   queued ──claim──▶ running ──finish──▶ done | failed | diverged
//     ▲ ▲                │                          │
//     │ └────give back───┘                          │   interrupted, lease expired, crashed (a second crash:
//     failed) └──────────retry──────────────────────────────┘   failed ones only
//
// A cancelled study's cases end as cancelled, unless another study wants them.
#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "runner/store/clock.hpp"
#include "runner/store/database.hpp"
#include "runner/study/study.hpp"
#include "solver/run_directory/run_ending.hpp"

namespace capstan {

struct Submission {
  std::string study_id;
  bool is_new = false;
  bool is_resumed = false;  ///< it was paused
};

/// The right to run one case; every later word about that run shows the token.
struct Claim {
  std::string case_id;
  std::string document;  ///< case.json
  std::string token;
  int attempt = 0;
  std::string handle;  ///< the executor's name of the run, once it has started
};

/// What became of the cases of a deleted study.
struct Deletion {
  int deleted = 0;  ///< cases, with their results
  int kept = 0;     ///< cases that other studies want, too
};

/// A client sent two different studies under one key.
class KeyReused : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

class JobQueue {
 public:
  static constexpr std::chrono::seconds kLease{60};
  static constexpr int kHeartbeats = 6;  ///< in one lease
  static constexpr int kMaxCrashes = 2;
  static constexpr std::chrono::seconds kBackOff{5};  ///< between a crash and the next attempt

  /// \param database  the writer; whoever shares the queue between threads locks
  JobQueue(Database& database, const Clock& clock, std::chrono::milliseconds lease = kLease)
      : database_(database), clock_(clock), lease_(lease) {}

  /// How often a claim is to be renewed.
  std::chrono::milliseconds heartbeat() const { return lease_ / kHeartbeats; }

  /// Equal cases are one case, and the same study again is the same study: its cancelled cases are queued
  /// again, and if it was paused it is resumed.
  /// \param key  by which the client knows this submission, or ""; throws KeyReused if it knew another study
  /// by it
  Submission submit(const Study& study, const std::string& key = "");

  // The following return how many cases they concern, and nothing if there is no such study.
  /// Queued cases are cancelled at once, running ones marked for it.
  std::optional<int> cancel(const std::string& study_id);
  /// The higher, the sooner; 0 at first. Concerns the queued cases.
  std::optional<int> set_priority(const std::string& study_id, int priority);
  /// What runs goes on, nothing is started. Concerns the queued cases.
  std::optional<int> pause(const std::string& study_id, bool is_paused);
  /// Queues its failed cases again, unless it is cancelled.
  std::optional<int> retry(const std::string& study_id);

  /// The study goes at once, and with it the cases that no other study wants: they become unwanted, the
  /// running ones among them end first. Nothing if there is no such study.
  std::optional<Deletion> remove(const std::string& study_id);
  /// Deletes at most that many unwanted cases that do not run; their ids. Whoever has removed their run
  /// directories says so by `forget`; until then, also of a later daemon, they are given again.
  std::vector<std::string> delete_unwanted(int most);
  void forget(const std::vector<std::string>& case_ids);

  /// The next case of the study whose turn it is: of the highest priority, and there of the one served
  /// longest ago.
  std::optional<Claim> claim();

  /// Remembers how the executor names the run.
  void started(const Claim& claim, const std::string& handle);

  // The following return false when the token holds no longer: then nothing is recorded, and the run is to
  // end.
  /// The run could not be started: that was no attempt. Tried again after a back-off, so that others have
  /// their turn.
  bool put_back(const Claim& claim, const std::string& reason);
  bool renew(const Claim& claim);
  /// Ends the attempt. The case is done, failed or diverged; or it is queued again, after an interruption and
  /// after the first crash.
  bool end(const Claim& claim, RunEnding ending, const std::string& reason);

  bool is_to_be_cancelled(const Claim& claim);

  /// All claims, to reconcile with the run directories when the daemon starts.
  std::vector<Claim> running();

  /// Gives back the cases whose holders have not renewed; their number. Those of which somebody knows that
  /// they are held are renewed: then the clock was set forward.
  int give_back_expired(const std::function<bool(const Claim&)>& is_held = [](const Claim&) {
    return false;
  });

 private:
  std::string study_id_for(const Study& study, const std::string& hash);
  bool resume(const std::string& study_id);
  bool is_repeated(const std::string& key, const std::string& document_hash);
  void add_points(const std::string& study_id, const Study& study);
  void want_cases(const std::string& study_id);
  std::optional<int> queued_cases(const std::string& study_id);  ///< nothing if there is no such study
  bool end_attempt(const Claim& claim, RunEnding ending, const std::string& reason);

  Database& database_;
  const Clock& clock_;
  const std::chrono::milliseconds lease_;
};

}  // namespace capstan
