#pragma once
// Reasons of the state of a case, or of the cases of a study, for people.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "runner/queries/run_place.hpp"
#include "runner/store/database.hpp"

namespace capstan {

/// {"id", "state", "reasons": ["..."]}; nothing if there is no such case.
std::optional<nlohmann::ordered_json> why(Database& database, const std::string& case_id,
                                          const RunPlaces& places);

/// Adds where it is to a running case, such as {"where": "Slurm's job 17_3 on node n1"}.
void add_place(Database& database, const RunPlaces& places, nlohmann::ordered_json& shown);
/// The same for a list of cases.
void add_places(Database& database, const RunPlaces& places, nlohmann::ordered_json& cases);

/// {"id", "state", "reasons": [{"cases": 3, "reason": "..."}]}: the study's cases grouped by reason. Nothing
/// if there is no such study.
std::optional<nlohmann::ordered_json> why_study(Database& database, const std::string& study_id,
                                                const RunPlaces& places);

}  // namespace capstan
