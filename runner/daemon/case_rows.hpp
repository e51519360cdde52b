#pragma once
// Cases as rows of the database.
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/store/database.hpp"
#include "solver/case/case.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// Queues the case if it is new or was cancelled. Returns its id.
std::string add_case(Database& database, const Case& c);

/// The id that cases with equal steps share (solver/case/equal_steps.hpp); "" for one of an older program.
std::string stored_steps_id(Database& database, const std::string& case_id);

struct StoredCase {
  std::string id;
  nlohmann::json document;
};

/// \param rows  a query with the columns id and document
std::vector<StoredCase> read_cases(Statement rows);

/// Parses a document that an earlier version stored: keys that have no effect today are dropped.
ParsedCase parse_stored_case(nlohmann::json document);

/// Applies `change` to all cases that a query returns, in batches of one transaction each, until the query
/// returns none. So `change` must alter each case such that the query no longer returns it. Batches bound the
/// memory that a large database needs, and a start that is killed continues where it was.
/// \param sql  a query with the columns id and document; its one parameter is the size of a batch
void change_in_batches(Database& database, const std::string& sql,
                       const std::function<void(const StoredCase&)>& change);

/// Estimates the cost of the cases that an earlier version stored without one.
void estimate_missing_costs(Database& database);

}  // namespace capstan
