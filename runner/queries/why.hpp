#pragma once
// What a case or the cases of a study wait for, or why they are where they are.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// {"id", "state", "reasons": ["..."]}, for people; nothing if there is no such case.
/// \param cores  on which the daemon runs cases
/// \param obstacle  what keeps all cases from being started, or ""
std::optional<nlohmann::ordered_json> why(Database& database, const std::string& case_id, std::size_t cores,
                                          const std::string& obstacle = "");

/// {"id", "state", "reasons": [{"cases": 3, "reason": "..."}]}: how many of a study's cases are where they
/// are for the same reason; nothing if there is no such study.
std::optional<nlohmann::ordered_json> why_study(Database& database, const std::string& study_id,
                                                const std::string& obstacle = "");

}  // namespace capstan
