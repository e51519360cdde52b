#pragma once
// The boundary of a study that seeks one: JSON of GET /v1/studies/{id}/boundary (schema/http.md).
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// Nothing if there is no such study, or if it seeks no boundary.
std::optional<nlohmann::ordered_json> find_boundary(Database& database, const std::string& study_id);

/// How many more points the study's search will probably ask for: a guess; 0 if it seeks no boundary.
int expected_points(Database& database, const std::string& study_id);

}  // namespace capstan
