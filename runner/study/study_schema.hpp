#pragma once
#include <nlohmann/json.hpp>

namespace capstan {

/// The JSON schema (draft 7) of a study file. Its parameters refer to case.schema.json, which stands beside
/// it.
nlohmann::ordered_json study_schema();

}  // namespace capstan
