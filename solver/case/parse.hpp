#pragma once
// From a case file's JSON to a valid Case, or to all the reasons why it is none.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/case/choice.hpp"

namespace capstan {

/// One fault of an input, at an RFC 6901 pointer into it.
struct Issue {
  std::string pointer;
  std::string message;
  bool without_effect = false;  ///< the key says nothing: the same case without it has no such fault
  bool operator==(const Issue&) const = default;
};
using Issues = std::vector<Issue>;

struct ParsedCase {
  std::optional<Case> value;  ///< engaged when issues is empty
  Issues issues;
  Choices choices;  ///< where the case is not what the file asks for: in its words, the solver's, and why
};

/// Reads a flat case. Unknown keys, keys without effect, wrong types and values out of range are issues;
/// all of them are reported.
ParsedCase parse_case(const nlohmann::json& json);

/// Takes the keys without effect out of a case's JSON: the fault that each of them was.
Issues drop_keys_without_effect(nlohmann::json& object);

/// JSON text with bounded depth. Syntax errors, depth over 32 and duplicate keys come back as issues.
struct ParsedJson {
  std::optional<nlohmann::json> value;
  Issues issues;
};
ParsedJson parse_json(std::string_view text);

/// The keys of a case whose value is a number or a word and may therefore be an axis of a study.
const std::vector<std::string_view>& scalar_parameters();

}  // namespace capstan
