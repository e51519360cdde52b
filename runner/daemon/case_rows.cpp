#include "runner/daemon/case_rows.hpp"

#include <algorithm>

#include "solver/case/content_id.hpp"
#include "solver/case/equal_steps.hpp"
#include "solver/case/run_cost.hpp"

namespace capstan {

std::string add_case(Database& database, const Case& c) {
  auto [id, document] = canonical(c);
  database.execute(
      "INSERT INTO cases (id, document, numerics, cost, steps_id) VALUES (?, ?, ?, ?, ?)"
      " ON CONFLICT (id) DO NOTHING",
      id, document, kNumericsVersion, case_cost(c), steps_id(c));
  database.execute("UPDATE cases SET state = 'queued', message = '' WHERE id = ? AND state = 'cancelled'",
                   id);
  return id;
}

std::string stored_steps_id(Database& database, const std::string& case_id) {
  Statement row = database.query("SELECT steps_id FROM cases WHERE id = ?", case_id);
  return row.step() ? row.text(0) : "";
}

std::vector<StoredCase> read_cases(Statement rows) {
  std::vector<StoredCase> cases;
  while (rows.step()) cases.push_back({rows.text(0), nlohmann::json::parse(rows.text(1))});
  return cases;
}

ParsedCase parse_stored_case(nlohmann::json document) {
  drop_keys_without_effect(document);
  return parse_case(document);
}

void change_in_batches(Database& database, const std::string& sql,
                       const std::function<void(const StoredCase&)>& change) {
  constexpr int kBatch = 1000;
  for (;;) {
    Transaction transaction(database, Survives::kill);
    const std::vector<StoredCase> batch = read_cases(database.query(sql, kBatch));
    for (const StoredCase& stored : batch) change(stored);
    transaction.commit();
    if (batch.empty()) return;
  }
}

void estimate_missing_costs(Database& database) {
  constexpr double kOfARefusedCase = 1;
  constexpr double kMin = 1e-9;  // 0 means "not estimated yet"
  change_in_batches(
      database, "SELECT id, document FROM cases WHERE cost = 0 LIMIT ?", [&](const StoredCase& stored) {
        const ParsedCase parsed = parse_stored_case(stored.document);
        const double cost = parsed.value ? case_cost(*parsed.value) : kOfARefusedCase;
        database.execute("UPDATE cases SET cost = ? WHERE id = ?", std::max(cost, kMin), stored.id);
      });
}

}  // namespace capstan
