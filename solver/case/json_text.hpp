#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "solver/case/issue.hpp"

namespace capstan {

struct ParsedJson {
  std::optional<nlohmann::json> value;  ///< has a value if `issues` is empty
  Issues issues;
};

/// Parses JSON text from an untrusted source. Syntax errors, a depth over 32 and duplicate keys are issues.
ParsedJson parse_json(std::string_view text);

}  // namespace capstan
