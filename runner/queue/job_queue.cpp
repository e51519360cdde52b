#include "runner/queue/job_queue.hpp"

#include <random>

#include "runner/queue/points.hpp"
#include "runner/queue/replacement.hpp"
#include "runner/store/fail_point.hpp"
#include "runner/study/small_letters.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

/// Of a row of unwanted_cases: a study has the case, or has another in its place.
constexpr const char* kIsWanted =
    "EXISTS (SELECT 1 FROM study_cases w WHERE w.case_id = unwanted_cases.case_id)"
    " OR EXISTS (SELECT 1 FROM study_cases w WHERE w.replaces = unwanted_cases.case_id)";

/// 128 random bits: no two claims share a token.
std::string new_token() {
  std::random_device entropy;
  std::string token;
  for (int i = 0; i < 4; ++i) token += std::to_string(entropy()) + (i < 3 ? "-" : "");
  return token;
}

Claim read_claim(const Statement& row) {
  return {row.text(0), row.text(1), row.text(2), static_cast<int>(row.integer(3)), row.text(4)};
}

}  // namespace

Submission JobQueue::submit(const Study& study, const std::string& key) {
  const std::string document = study.document.dump();
  const std::string hash = sha256_hex(document);
  Transaction transaction(database_);
  const bool is_same_request = !key.empty() && is_repeated(key, hash);
  const std::string identity = std::to_string(kNumericsVersion) + ":" + hash;
  Statement known = database_.query("SELECT id FROM studies WHERE document_hash = ?", identity);
  Submission submission;
  submission.is_new = !known.step();
  submission.study_id = submission.is_new ? study_id_for(study, hash) : known.text(0);
  if (submission.is_new) {
    database_.execute(
        "INSERT INTO studies (id, name, description, document, document_hash, axes, notes, submitted_at)"
        " VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
        submission.study_id, study.name, study.description, document, identity, listed(study.axes).dump(),
        nlohmann::json(study.notes).dump(), clock_.now());
    add_points(submission.study_id, study);
  } else {
    database_.execute("UPDATE studies SET cancelled_at = NULL WHERE id = ?", submission.study_id);
    submission.is_resumed = !is_same_request && resume(submission.study_id);
  }
  want_cases(submission.study_id);
  fail_point("submitting");
  transaction.commit();
  return submission;
}

/// The name in small letters and as many digits of the hash as make it unique, four as a rule: "fig16a-3f9c".
std::string JobQueue::study_id_for(const Study& study, const std::string& hash) {
  const std::string name = in_small_letters(study.name);
  for (std::size_t digits = 4;; ++digits) {
    const std::string id = name + "-" + hash.substr(0, digits);
    if (!database_.query("SELECT 1 FROM studies WHERE id = ?", id).step()) return id;
  }
}

/// False if it was not paused.
bool JobQueue::resume(const std::string& study_id) {
  return database_.execute("UPDATE schedule SET is_paused = 0 WHERE study_id = ? AND is_paused = 1",
                           study_id) > 0;
}

/// True if a client has sent the same under this key before; otherwise the key is remembered.
bool JobQueue::is_repeated(const std::string& key, const std::string& document_hash) {
  const int added = database_.execute("INSERT INTO idempotency_keys VALUES (?, ?, ?) ON CONFLICT DO NOTHING",
                                      key, document_hash, clock_.now());
  Statement row = database_.query("SELECT document_hash FROM idempotency_keys WHERE key = ?", key);
  if (!row.step() || row.text(0) != document_hash)
    throw KeyReused("the key \"" + key + "\" came with another study before");
  return added == 0;
}

void JobQueue::add_points(const std::string& study_id, const Study& study) {
  std::vector<std::string> ids;
  for (const Case& c : study.cases) ids.push_back(add_case(database_, c));
  for (std::size_t point = 0; point < study.points.size(); ++point)
    add_point(database_, {study_id, static_cast<std::int64_t>(point), ids[study.points[point]],
                          study.asked_at(point).dump(), ""});
}

/// Those that were cancelled, or are about to be, are wanted again.
void JobQueue::want_cases(const std::string& study_id) {
  const std::string wanted = " AND id IN (SELECT case_id FROM study_cases WHERE study_id = ?)";
  database_.execute("UPDATE cases SET state = 'queued', message = '' WHERE state = 'cancelled'" + wanted,
                    study_id);
  database_.execute("UPDATE cases SET cancel_requested = 0 WHERE cancel_requested = 1" + wanted, study_id);
}

std::optional<int> JobQueue::cancel(const std::string& study_id) {
  Transaction transaction(database_);
  const int known =
      database_.execute("UPDATE studies SET cancelled_at = ? WHERE id = ?", clock_.now(), study_id);
  if (known == 0) return std::nullopt;
  const std::string unwanted =
      " AND id IN (SELECT case_id FROM study_cases WHERE study_id = ?) AND NOT EXISTS (SELECT 1 FROM "
      "study_cases w"
      " JOIN studies s ON s.id = w.study_id WHERE w.case_id = cases.id AND s.cancelled_at IS NULL)";
  const int queued = database_.execute(
      "UPDATE cases SET state = 'cancelled', message = 'cancelled by the user' WHERE state = 'queued'" +
          unwanted,
      study_id);
  const int running =
      database_.execute("UPDATE cases SET cancel_requested = 1 WHERE state = 'running'" + unwanted, study_id);
  transaction.commit();
  return queued + running;
}

std::optional<Deletion> JobQueue::remove(const std::string& study_id) {
  Transaction transaction(database_);
  if (!cancel(study_id)) return std::nullopt;
  const int all = database_.execute(
      "INSERT OR IGNORE INTO unwanted_cases SELECT case_id FROM study_cases WHERE study_id = ?1"
      " UNION SELECT replaces FROM study_cases WHERE study_id = ?1 AND replaces IS NOT NULL",
      study_id);
  for (const char* table : {"study_cases", "schedule"})
    database_.execute("DELETE FROM " + std::string(table) + " WHERE study_id = ?", study_id);
  database_.execute("DELETE FROM studies WHERE id = ?", study_id);
  const int kept = database_.execute("DELETE FROM unwanted_cases WHERE " + std::string(kIsWanted));
  transaction.commit();
  return Deletion{all - kept, kept};
}

std::vector<std::string> JobQueue::delete_unwanted(int most) {
  if (!database_.query("SELECT 1 FROM unwanted_cases LIMIT 1").step()) return {};
  Transaction transaction(database_);
  database_.execute("DELETE FROM unwanted_cases WHERE " +
                    std::string(kIsWanted));  // submitted again meanwhile
  std::vector<std::string> ids;
  Statement row = database_.query(
      "SELECT case_id FROM unwanted_cases LEFT JOIN cases ON id = case_id WHERE state IS NOT 'running' LIMIT "
      "?",
      most);
  while (row.step()) ids.push_back(row.text(0));
  for (const std::string& id : ids) {
    for (const char* table : {"histories", "results", "attempts"})
      database_.execute("DELETE FROM " + std::string(table) + " WHERE case_id = ?", id);
    database_.execute("DELETE FROM cases WHERE id = ?", id);
  }
  transaction.commit();
  fail_point("deleted");
  return ids;
}

void JobQueue::forget(const std::vector<std::string>& case_ids) {
  if (case_ids.empty()) return;
  Transaction transaction(database_, Survives::kill);
  for (const std::string& id : case_ids)
    database_.execute("DELETE FROM unwanted_cases WHERE case_id = ?", id);
  transaction.commit();
}

std::optional<int> JobQueue::queued_cases(const std::string& study_id) {
  Statement row = database_.query("SELECT queued FROM schedule WHERE study_id = ?", study_id);
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

/// A back-off that ends later than one that began now was written before the clock was set back: it is over.
std::optional<Claim> JobQueue::claim() {
  Transaction transaction(database_, Survives::kill);
  const Time now = clock_.now();
  Statement turn = database_.query(
      "SELECT s.number, w.case_id FROM schedule s JOIN waiting w ON w.study_number = s.number"
      " WHERE s.queued > 0 AND s.is_paused = 0 AND (w.not_before <= ?1 OR w.not_before > ?2)"
      " ORDER BY s.priority DESC, s.served, s.number, w.position LIMIT 1",
      now, Time(now + kBackOff));
  if (!turn.step()) return std::nullopt;
  Statement row = database_.query(
      "UPDATE cases SET state = 'running', message = '', attempt = attempt + 1, token = ?, lease_until = ?"
      " WHERE id = ? RETURNING id, document, token, attempt, ''",
      new_token(), Time(now + lease_), turn.text(1));
  row.step();
  const Claim claim = read_claim(row);
  row.step();
  database_.execute("UPDATE schedule SET served = 1 + (SELECT max(served) FROM schedule) WHERE number = ?",
                    turn.integer(0));
  database_.execute("INSERT INTO attempts (case_id, attempt, started_at) VALUES (?, ?, ?)", claim.case_id,
                    claim.attempt, now);
  transaction.commit();
  fail_point("claimed");
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
      " state = iif(cancel_requested, 'cancelled', 'queued'), cancel_requested = 0 WHERE id = ? AND token = "
      "?",
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
      database_.execute(
          "UPDATE cases SET state = iif(cancel_requested, 'cancelled', 'queued'),"
          " message = iif(cancel_requested, 'cancelled by the user', ?), cancel_requested = 0 WHERE id = ?",
          reason, claim.case_id);
      break;
    case RunEnding::crashed:
      database_.execute(
          "UPDATE cases SET crashes = crashes + 1, message = ?1, cancel_requested = 0, not_before = ?4,"
          " state = CASE WHEN cancel_requested THEN 'cancelled' WHEN crashes + 1 < ?2 THEN 'queued' ELSE "
          "'failed' END"
          " WHERE id = ?3",
          reason, kMaxCrashes, claim.case_id, Time(clock_.now() + kBackOff));
  }
  transaction.commit();
  return true;
}

bool JobQueue::is_to_be_cancelled(const Claim& claim) {
  return database_
      .query("SELECT 1 FROM cases WHERE id = ? AND token = ? AND cancel_requested", claim.case_id,
             claim.token)
      .step();
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
      given_back += end(claim, RunEnding::interrupted, "its lease expired: nobody was heard of it");
  transaction.commit();
  return given_back;
}

}  // namespace capstan
