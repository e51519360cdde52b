#pragma once
// Result of a run as a row of the database.
#include <nlohmann/json.hpp>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// Stores the result of a case in place of an earlier one.
/// \param result  result.json of the run
void store_result(Database& database, const std::string& case_id, const nlohmann::ordered_json& result);

}  // namespace capstan
