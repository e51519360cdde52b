#pragma once
// Parser of case files: from JSON to a valid Case, or to the list of all issues.
#include <nlohmann/json.hpp>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/case/choice.hpp"
#include "solver/case/issue.hpp"
#include "solver/case/json_text.hpp"
#include "solver/case/parameters.hpp"

namespace capstan {

struct ParsedCase {
  std::optional<Case> value;  ///< has a value if `issues` is empty
  Issues issues;
  Choices choices;  ///< where the case differs from what the file asks for, and why
};

/// Reads a case file. Unknown keys, keys without effect, wrong types and values out of range are issues; all
/// of them are reported.
ParsedCase parse_case(const nlohmann::json& json);

/// Removes the keys without effect from the JSON of a case. Returns one issue for each removed key.
Issues drop_keys_without_effect(nlohmann::json& object);

}  // namespace capstan
