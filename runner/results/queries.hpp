#pragma once
// What people and programs ask of the database, as the JSON that answers them.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runner/queue/database.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// All studies, the newest first.
nlohmann::ordered_json list_studies(Database& database);

/// One study: its axes, how many cases are in which state and of which motion, and its progress from 0 to 1.
std::optional<nlohmann::ordered_json> find_study(Database& database, const std::string& study_id);

/// Conditions on cases, all to be met: {"motion", "tumbling"}, {"state", "done"}, or a parameter and its
/// value.
using CaseFilter = std::vector<std::pair<std::string, std::string>>;

/// The conditions that cannot be met, since there is no such parameter, state or motion.
Issues check_filter(const CaseFilter& filter);

/// The cases of a study, in the study's order. The filter has been checked.
nlohmann::ordered_json find_cases(Database& database, const std::string& study_id, const CaseFilter& filter);

/// One case: parameters, state, motion, evidence and the rest of its result, its attempts and its studies.
std::optional<nlohmann::ordered_json> find_case(Database& database, const std::string& case_id);

/// {"kt": [..], "D_xy": [..], …}: the recorded times of a case; nothing if there is no such case.
std::optional<nlohmann::ordered_json> find_history(Database& database, const std::string& case_id);

}  // namespace capstan
