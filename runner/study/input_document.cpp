#include "runner/study/input_document.hpp"

#include <algorithm>

#include "runner/study/issue_collector.hpp"

namespace capstan {
namespace {

/// Whether a document holds the parameters of one case: a study has them in its "base".
bool is_case(const nlohmann::json& document) {
  if (!document.is_object() || document.contains("base") || document.contains("axes")) return false;
  const auto is_given = [&](std::string_view parameter) { return document.contains(parameter); };
  return std::ranges::any_of(scalar_parameters(), is_given);
}

InputDocument of_case(ParsedCase parsed) {
  limit_number(parsed.issues);
  return {std::nullopt, std::move(parsed.value), std::move(parsed.choices), std::move(parsed.issues)};
}

InputDocument of_study(ParsedStudy parsed) {
  return {std::move(parsed.value), std::nullopt, {}, std::move(parsed.issues)};
}

}  // namespace

InputDocument parse_document(const std::string& text) {
  ParsedJson json = parse_json(text);
  limit_number(json.issues);
  if (!json.value) return {std::nullopt, std::nullopt, {}, std::move(json.issues)};
  return is_case(*json.value) ? of_case(parse_case(*json.value)) : of_study(parse_study(*json.value));
}

}  // namespace capstan
