#pragma once
// From a case file's JSON to a valid Case, or to all the reasons why it is none.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// One fault of an input, at an RFC 6901 pointer into it.
struct Issue {
  std::string pointer;
  std::string message;
  bool operator==(const Issue&) const = default;
};
using Issues = std::vector<Issue>;

struct ParsedCase {
  std::optional<Case> value;  ///< engaged when issues is empty
  Issues issues;
};

/// Reads a flat case. Unknown keys, keys without effect, wrong types and values out of range are issues;
/// all of them are reported.
ParsedCase parse_case(const nlohmann::json& json);

/// JSON text with bounded depth. Syntax errors, depth over 32 and duplicate keys come back as issues.
struct ParsedJson {
  std::optional<nlohmann::json> value;
  Issues issues;
};
ParsedJson parse_json(std::string_view text);

/// The keys of a case whose value is a number or a word and may therefore be an axis of a study.
const std::vector<std::string_view>& scalar_parameters();

}  // namespace capstan
