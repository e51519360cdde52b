#include "runner/queue/job_queue.hpp"

#include "runner/store/fail_point.hpp"
#include "solver/run_directory/attempt_token.hpp"

namespace capstan {
namespace {

Claim read_claim(const Statement& row) {
  return {row.text(0), row.text(1), row.text(2), static_cast<int>(row.integer(3)), row.text(4)};
}

}  // namespace

std::optional<int> JobQueue::cancel(const std::string& study_id) {
  Transaction transaction(database_);
  const int known =
      database_.execute("UPDATE studies SET cancelled_at = ? WHERE id = ?", clock_.now(), study_id);
  if (known == 0) return std::nullopt;
  const std::string unwanted =
      " AND id IN (SELECT case_id FROM study_cases WHERE study_id = ?)"
      " AND NOT EXISTS (SELECT 1 FROM study_cases w JOIN studies s ON s.id = w.study_id"
      " WHERE w.case_id = cases.id AND s.cancelled_at IS NULL)";
  const int queued = database_.execute(
      "UPDATE cases SET state = 'cancelled', message = 'cancelled by the user' WHERE state = 'queued'" +
          unwanted,
      study_id);
  const int running =
      database_.execute("UPDATE cases SET cancel_requested = 1 WHERE state = 'running'" + unwanted, study_id);
  transaction.commit();
  return queued + running;
}

/// Nothing if there is no such study.
std::optional<int> JobQueue::queued_cases(const std::string& study_id) {
  Statement row = database_.query(
      "SELECT count FROM studies LEFT JOIN tallies ON study_id = id AND word = 'queued' WHERE id = ?",
      study_id);
  if (!row.step()) return std::nullopt;
  return static_cast<int>(row.integer(0));
}

std::optional<int> JobQueue::set_priority(const std::string& study_id, int priority) {
  Transaction transaction(database_);
  database_.execute("UPDATE schedule SET priority = ? WHERE study_id = ?", priority, study_id);
  transaction.commit();
  return queued_cases(study_id);
}

std::optional<int> JobQueue::pause(const std::string& study_id, bool is_paused) {
  Transaction transaction(database_);
  database_.execute("UPDATE schedule SET is_paused = ? WHERE study_id = ?", is_paused ? 1 : 0, study_id);
  transaction.commit();
  return queued_cases(study_id);
}

std::optional<int> JobQueue::retry(const std::string& study_id) {
  if (!queued_cases(study_id)) return std::nullopt;
  Transaction transaction(database_);
  const int failed = database_.execute(
      "UPDATE cases SET state = 'queued', crashes = 0, not_before = 0, message = 'to be tried again'"
      " WHERE state = 'failed' AND id IN (SELECT case_id FROM study_cases JOIN studies s ON s.id = study_id"
      " WHERE s.id = ? AND cancelled_at IS NULL)",
      study_id);
  transaction.commit();
  return failed;
}

/// A `not_before` further ahead than one back-off means that the clock was set back: it is ignored.
std::optional<Claim> JobQueue::claim() {
  Transaction transaction(database_, Survives::kill);
  const Time now = clock_.now();
  Statement turn = database_.query(
      "SELECT s.number, w.case_id FROM schedule s JOIN waiting w ON w.study_number = s.number"
      " WHERE s.waiting > 0 AND s.is_paused = 0 AND (w.not_before <= ?1 OR w.not_before > ?2)"
      " ORDER BY s.priority DESC, s.served, s.number, w.position LIMIT 1",
      now, Time(now + kBackOff));
  if (!turn.step()) return std::nullopt;
  const std::optional<Claim> claim = claim_queued(turn.text(1), now);
  database_.execute("UPDATE schedule SET served = 1 + (SELECT max(served) FROM schedule) WHERE number = ?",
                    turn.integer(0));
  transaction.commit();
  fail_point("claimed");
  return claim;
}

std::optional<Claim> JobQueue::claim_case(const std::string& case_id) {
  Transaction transaction(database_, Survives::kill);
  const std::optional<Claim> claim = claim_queued(case_id, clock_.now());
  transaction.commit();
  return claim;
}

/// Nothing if the case is not queued.
std::optional<Claim> JobQueue::claim_queued(const std::string& case_id, Time now) {
  Statement row = database_.query(
      "UPDATE cases SET state = 'running', message = '', attempt = attempt + 1, token = ?, lease_until = ?"
      " WHERE id = ? AND state = 'queued' RETURNING id, document, token, attempt, ''",
      new_token(), Time(now + lease_), case_id);
  if (!row.step()) return std::nullopt;
  const Claim claim = read_claim(row);
  row.step();
  database_.execute("INSERT INTO attempts (case_id, attempt, started_at) VALUES (?, ?, ?)", claim.case_id,
                    claim.attempt, now);
  return claim;
}

void JobQueue::started(const Claim& claim, const std::string& handle) {
  Transaction transaction(database_, Survives::kill);
  database_.execute("UPDATE attempts SET handle = ? WHERE case_id = ? AND attempt = ?", handle, claim.case_id,
                    claim.attempt);
  transaction.commit();
}

bool JobQueue::put_back(const Claim& claim, const std::string& reason) {
  Transaction transaction(database_, Survives::kill);
  const int held = database_.execute(
      "UPDATE cases SET token = NULL, lease_until = NULL, attempt = attempt - 1, message = ?, not_before = ?,"
      " state = iif(cancel_requested, 'cancelled', 'queued'), cancel_requested = 0"
      " WHERE id = ? AND token = ?",
      reason, Time(clock_.now() + kBackOff), claim.case_id, claim.token);
  if (held == 0) return false;
  database_.execute("DELETE FROM attempts WHERE case_id = ? AND attempt = ?", claim.case_id, claim.attempt);
  transaction.commit();
  return true;
}

bool JobQueue::renew(const Claim& claim) {
  Transaction transaction(database_, Survives::kill);
  const int renewed = database_.execute("UPDATE cases SET lease_until = ? WHERE id = ? AND token = ?",
                                        Time(clock_.now() + lease_), claim.case_id, claim.token);
  transaction.commit();
  return renewed > 0;
}

/// Closes the attempt and withdraws the token; false if the token was no longer valid.
bool JobQueue::end_attempt(const Claim& claim, RunEnding ending, const std::string& reason) {
  const int held =
      database_.execute("UPDATE cases SET token = NULL, lease_until = NULL WHERE id = ? AND token = ?",
                        claim.case_id, claim.token);
  if (held == 0) return false;
  database_.execute(
      "UPDATE attempts SET ended_at = ?, ending = ?, reason = ? WHERE case_id = ? AND attempt = ?",
      clock_.now(), to_string(ending), reason, claim.case_id, claim.attempt);
  return true;
}

void JobQueue::requeue(const Claim& claim, const std::string& reason) {
  database_.execute(
      "UPDATE cases SET state = iif(cancel_requested, 'cancelled', 'queued'),"
      " message = iif(cancel_requested, 'cancelled by the user', ?), cancel_requested = 0 WHERE id = ?",
      reason, claim.case_id);
}

/// After kMaxCrashes crashes the case becomes failed instead.
void JobQueue::requeue_after_crash(const Claim& claim, const std::string& reason) {
  database_.execute(
      "UPDATE cases SET crashes = crashes + 1, message = ?1, cancel_requested = 0, not_before = ?4,"
      " state = CASE WHEN cancel_requested THEN 'cancelled' WHEN crashes + 1 < ?2 THEN 'queued'"
      " ELSE 'failed' END WHERE id = ?3",
      reason, kMaxCrashes, claim.case_id, Time(clock_.now() + kBackOff));
}

bool JobQueue::end(const Claim& claim, RunEnding ending, const std::string& reason) {
  Transaction transaction(database_);
  if (!end_attempt(claim, ending, reason)) return false;
  switch (ending) {
    case RunEnding::done:
    case RunEnding::failed:
    case RunEnding::diverged:
      database_.execute("UPDATE cases SET state = ?, message = ?, cancel_requested = 0 WHERE id = ?",
                        to_string(ending), reason, claim.case_id);
      break;
    case RunEnding::interrupted:
      requeue(claim, reason);
      break;
    case RunEnding::crashed:
      requeue_after_crash(claim, reason);
  }
  transaction.commit();
  return true;
}

std::set<std::string> JobQueue::to_be_cancelled() {
  std::set<std::string> tokens;
  Statement row = database_.query("SELECT token FROM cases WHERE state = 'running' AND cancel_requested");
  while (row.step()) tokens.insert(row.text(0));
  return tokens;
}

std::size_t JobQueue::waiting() {
  Statement row = database_.query("SELECT count FROM totals WHERE what = 'cases' AND name = 'queued'");
  return row.step() ? static_cast<std::size_t>(row.integer(0)) : 0;
}

std::vector<Claim> JobQueue::running() {
  std::vector<Claim> claims;
  Statement row = database_.query(
      "SELECT c.id, c.document, c.token, c.attempt, a.handle FROM cases c"
      " JOIN attempts a ON a.case_id = c.id AND a.attempt = c.attempt WHERE c.state = 'running'");
  while (row.step()) claims.push_back(read_claim(row));
  return claims;
}

int JobQueue::give_back_expired(const std::function<bool(const Claim&)>& is_held) {
  Transaction transaction(database_, Survives::kill);
  std::vector<Claim> expired;
  Statement row = database_.query(
      "SELECT id, document, token, attempt, '' FROM cases WHERE state = 'running' AND lease_until < ?",
      clock_.now());
  while (row.step()) expired.push_back(read_claim(row));
  int given_back = 0;
  for (const Claim& claim : expired)
    if (is_held(claim))
      renew(claim);
    else
      given_back += end(claim, RunEnding::interrupted, "its lease expired without a heartbeat");
  transaction.commit();
  return given_back;
}

}  // namespace capstan
