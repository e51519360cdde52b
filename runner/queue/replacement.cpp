#include "runner/queue/replacement.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "runner/queue/points.hpp"
#include "solver/case/content_id.hpp"
#include "solver/case/run_cost.hpp"

namespace capstan {
namespace {

struct Stored {
  std::string id;
  nlohmann::json document;
};

std::vector<Stored> read_cases(Statement row) {
  std::vector<Stored> cases;
  while (row.step()) cases.push_back({row.text(0), nlohmann::json::parse(row.text(1))});
  return cases;
}

/// A case as an earlier version has stored it: some of its keys may have no effect today.
ParsedCase parse_stored_case(nlohmann::json document) {
  drop_keys_without_effect(document);
  return parse_case(document);
}

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

/// Changes the cases of a query, which must not find those that were changed, some at a time: all of a large
/// database would take gigabytes, and a start that is ended goes on where it was.
void change_all(Database& database, const std::string& sql,
                const std::function<void(const Stored&)>& change) {
  constexpr int kTogether = 1000;
  for (;;) {
    Transaction transaction(database, Survives::kill);
    const std::vector<Stored> some = read_cases(database.query(sql, kTogether));
    for (const Stored& old : some) change(old);
    transaction.commit();
    if (some.empty()) return;
  }
}

/// What is wrong with the fidelity whatever the model of the flow; nothing if there is no such study.
Issues faults_of_fidelity(Database& database, const std::string& study_id, const nlohmann::json& fidelity) {
  Issues issues;
  for (auto& [id, document] : read_cases(database.query("SELECT c.id, c.document FROM study_cases JOIN cases "
                                                        "c ON c.id = case_id WHERE study_id = ? LIMIT 1",
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

std::string add_case(Database& database, const Case& c) {
  auto [id, document] = canonical(c);
  database.execute(
      "INSERT INTO cases (id, document, numerics, cost) VALUES (?, ?, ?, ?) ON CONFLICT (id) DO NOTHING", id,
      document, kNumericsVersion, run_cost(c));
  database.execute("UPDATE cases SET state = 'queued', message = '' WHERE id = ? AND state = 'cancelled'",
                   id);
  return id;
}

Issues replace_failed(Database& database, const std::string& study_id, const nlohmann::json& fidelity) {
  Transaction transaction(database);
  Issues issues = faults_of_fidelity(database, study_id, fidelity);
  if (!issues.empty()) return issues;
  for (auto& [id, document] : read_cases(
           database.query("SELECT c.id, c.document FROM study_cases JOIN cases c ON c.id = case_id JOIN "
                          "studies s ON s.id = study_id"
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

void price_cases(Database& database) {
  constexpr double kOfARefusedCase = 1;
  constexpr double kMin = 1e-9;  // 0 is "not known yet"
  change_all(database, "SELECT id, document FROM cases WHERE cost = 0 LIMIT ?", [&](const Stored& old) {
    const ParsedCase parsed = parse_stored_case(old.document);
    const double cost = parsed.value ? run_cost(*parsed.value) : kOfARefusedCase;
    database.execute("UPDATE cases SET cost = ? WHERE id = ?", std::max(cost, kMin), old.id);
  });
}

void replace_outdated(Database& database) {
  static const std::string outdated =
      "SELECT id, document FROM cases WHERE state = 'queued' AND numerics <> " +
      std::to_string(kNumericsVersion) + " LIMIT ?";
  change_all(database, outdated, [&](const Stored& old) {
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
