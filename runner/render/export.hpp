#pragma once
// Results as tables.
#include <nlohmann/json.hpp>

#include "runner/render/table.hpp"

namespace capstan {

/// For people: what was asked for, what varies, and what came of it.
/// \param study  as find_study gives it  \param cases  as find_cases gives them
Table summary_table(const nlohmann::ordered_json& study, const nlohmann::ordered_json& cases);

/// For programs: everything that was asked for, resolved and found, one point a row (schema/results.md).
Table full_table(const nlohmann::ordered_json& cases);

/// \param history  as find_history gives it
Table history_table(const nlohmann::ordered_json& history);

}  // namespace capstan
