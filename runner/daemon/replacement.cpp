#include "runner/daemon/replacement.hpp"

#include <utility>

#include "runner/daemon/case_rows.hpp"
#include "runner/daemon/points.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

/// \param study_id  the study whose points are changed; "": all studies
void replace(Database& database, const std::string& old_id, const Case& by,
             const std::string& study_id = "") {
  const std::string id = add_case(database, by);
  if (id == old_id) return;
  for (Point& point : points_of_case(database, old_id, study_id)) {
    remove_point(database, point);
    point.replaces = std::exchange(point.case_id, id);
    add_point(database, point);
  }
}

/// The issues that the study's first case has at this fidelity. Settings without effect in its flow model are
/// no issues. None if there is no such study.
Issues issues_of_fidelity(Database& database, const std::string& study_id, const nlohmann::json& fidelity) {
  Issues issues;
  for (auto& [id, document] :
       read_cases(database.query("SELECT c.id, c.document FROM study_cases JOIN cases c ON c.id = case_id"
                                 " WHERE study_id = ? LIMIT 1",
                                 study_id))) {
    document["fidelity"] = fidelity;
    issues = parse_case(document).issues;
    std::erase_if(issues, [](const Issue& issue) { return issue.without_effect; });
  }
  return issues;
}

std::string text_of(const Issues& issues) {
  std::string text;
  for (const Issue& issue : issues) text += "\n" + issue.pointer + ": " + issue.message;
  return text;
}

}  // namespace

Issues replace_failed(Database& database, const std::string& study_id, const nlohmann::json& fidelity) {
  Transaction transaction(database);
  Issues issues = issues_of_fidelity(database, study_id, fidelity);
  if (!issues.empty()) return issues;
  for (auto& [id, document] : read_cases(
           database.query("SELECT c.id, c.document FROM study_cases JOIN cases c ON c.id = case_id"
                          " JOIN studies s ON s.id = study_id"
                          " WHERE s.id = ? AND cancelled_at IS NULL AND state IN ('failed', 'diverged')",
                          study_id))) {
    document["fidelity"] = fidelity;
    const ParsedCase parsed = parse_case(document);
    if (parsed.value) replace(database, id, *parsed.value, study_id);
    issues = parsed.issues;
    if (!issues.empty()) break;
  }
  if (issues.empty()) transaction.commit();
  return issues;
}

void replace_outdated(Database& database) {
  static const std::string outdated =
      "SELECT id, document FROM cases WHERE state = 'queued' AND numerics <> " +
      std::to_string(kNumericsVersion) + " LIMIT ?";
  change_in_batches(database, outdated, [&](const StoredCase& old) {
    const ParsedCase parsed = parse_stored_case(old.document);
    if (parsed.value) replace(database, old.id, *parsed.value);
    database.execute(
        "UPDATE cases SET state = ?, message = ? WHERE id = ?", parsed.value ? "cancelled" : "failed",
        parsed.value ? "a later numerics version computes case " + case_id(*parsed.value) + " instead"
                     : "this version refuses the case" + text_of(parsed.issues),
        old.id);
  });
}

}  // namespace capstan
