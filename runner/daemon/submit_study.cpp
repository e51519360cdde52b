#include "runner/daemon/submit_study.hpp"

#include <vector>

#include "runner/daemon/case_rows.hpp"
#include "runner/daemon/extend_search.hpp"
#include "runner/daemon/points.hpp"
#include "runner/store/fail_point.hpp"
#include "runner/study/small_letters.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

/// The name in lower case and the first digits of the hash: at least four, and as many as make the id unique,
/// such as "fig16a-3f9c".
std::string new_study_id(Database& database, const Study& study, const std::string& hash) {
  const std::string name = in_small_letters(study.name);
  for (std::size_t digits = 4;; ++digits) {
    const std::string id = name + "-" + hash.substr(0, digits);
    if (!database.query("SELECT 1 FROM studies WHERE id = ?", id).step()) return id;
  }
}

/// True if the same document came under this key before; otherwise the key is stored.
bool is_repeated(Database& database, const Clock& clock, const std::string& key,
                 const std::string& document_hash) {
  const int added = database.execute("INSERT INTO idempotency_keys VALUES (?, ?, ?) ON CONFLICT DO NOTHING",
                                     key, document_hash, clock.now());
  Statement row = database.query("SELECT document_hash FROM idempotency_keys WHERE key = ?", key);
  if (!row.step() || row.text(0) != document_hash)
    throw KeyReused("the key \"" + key + "\" came with another study before");
  return added == 0;
}

void add_points(Database& database, const std::string& study_id, const Study& study) {
  std::vector<std::string> ids;
  for (const Case& c : study.cases) ids.push_back(add_case(database, c));
  for (std::size_t point = 0; point < study.points.size(); ++point)
    add_point(database, {study_id, static_cast<std::int64_t>(point), ids[study.points[point]],
                         study.asked_at(point).dump(), ""});
}

/// False if the study was not paused.
bool resume(Database& database, const std::string& study_id) {
  return database.execute("UPDATE schedule SET is_paused = 0 WHERE study_id = ? AND is_paused = 1",
                          study_id) > 0;
}

/// Queues the cancelled cases of the study again and withdraws requests to cancel its running cases.
void withdraw_cancellations(Database& database, const std::string& study_id) {
  const std::string of_study = " AND id IN (SELECT case_id FROM study_cases WHERE study_id = ?)";
  database.execute("UPDATE cases SET state = 'queued', message = '' WHERE state = 'cancelled'" + of_study,
                   study_id);
  database.execute("UPDATE cases SET cancel_requested = 0 WHERE cancel_requested = 1" + of_study, study_id);
}

}  // namespace

Submission submit_study(Database& database, const Clock& clock, const Study& study, const std::string& key) {
  const std::string document = study.document.dump();
  const std::string hash = sha256_hex(document);
  Transaction transaction(database);
  const bool is_same_request = !key.empty() && is_repeated(database, clock, key, hash);
  const std::string identity = std::to_string(kNumericsVersion) + ":" + hash;
  Statement known = database.query("SELECT id FROM studies WHERE document_hash = ?", identity);
  Submission submission;
  submission.is_new = !known.step();
  submission.study_id = submission.is_new ? new_study_id(database, study, hash) : known.text(0);
  if (submission.is_new) {
    database.execute(
        "INSERT INTO studies (id, name, description, document, document_hash, axes, notes, submitted_at)"
        " VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
        submission.study_id, study.name, study.description, document, identity, listed(study.axes).dump(),
        nlohmann::json(study.notes).dump(), clock.now());
    add_points(database, submission.study_id, study);
  } else {
    database.execute("UPDATE studies SET cancelled_at = NULL WHERE id = ?", submission.study_id);
    submission.is_resumed = !is_same_request && resume(database, submission.study_id);
  }
  withdraw_cancellations(database, submission.study_id);
  extend_search(database, submission.study_id);  // its first points may be known cases
  fail_point("submitting");
  transaction.commit();
  return submission;
}

}  // namespace capstan
