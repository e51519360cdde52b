#pragma once
// What came of a run, as the database keeps it.
#include <nlohmann/json.hpp>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// \param result  result.json of the run
void store_result(Database& database, const std::string& case_id, const nlohmann::ordered_json& result);

}  // namespace capstan
