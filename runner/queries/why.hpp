#pragma once
// Reasons of the state of a case, or of the cases of a study, for people.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// {"id", "state", "reasons": ["..."]}; nothing if there is no such case.
/// \param cores  number of cases that the daemon runs at once
/// \param obstacle  what prevents the start of any case, or ""
std::optional<nlohmann::ordered_json> why(Database& database, const std::string& case_id, std::size_t cores,
                                          const std::string& obstacle = "");

/// {"id", "state", "reasons": [{"cases": 3, "reason": "..."}]}: the study's cases grouped by reason. Nothing
/// if there is no such study.
std::optional<nlohmann::ordered_json> why_study(Database& database, const std::string& study_id,
                                                const std::string& obstacle = "");

}  // namespace capstan
