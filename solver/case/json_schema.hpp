#pragma once
#include <nlohmann/json.hpp>

namespace capstan {

/// The JSON schema (draft 7) of a case file, made from the table of parameters.
nlohmann::ordered_json case_schema();

}  // namespace capstan
