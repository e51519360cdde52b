#pragma once
// What a case waits for, or why it is where it is.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "runner/queue/database.hpp"

namespace capstan {

/// {"id", "state", "reasons": ["..."]}, for people; nothing if there is no such case.
/// \param cores  on which the daemon runs cases
/// \param obstacle  what keeps all cases from being started, or ""
std::optional<nlohmann::ordered_json> why(Database& database, const std::string& case_id, std::size_t cores,
                                          const std::string& obstacle = "");

}  // namespace capstan
