#pragma once
// Results as tables.
#include <nlohmann/json.hpp>

#include "runner/results/table.hpp"

namespace capstan {

/// For people: what varies, and what came of it.
/// \param study  as find_study gives it  \param cases  as find_cases gives them
Table summary_table(const nlohmann::ordered_json& study, const nlohmann::ordered_json& cases);

/// For programs: every parameter of the cases and everything that was found, one case a row.
Table full_table(const nlohmann::ordered_json& cases);

/// \param history  as find_history gives it
Table history_table(const nlohmann::ordered_json& history);

}  // namespace capstan
