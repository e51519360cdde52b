#include "runner/study/study.hpp"

#include <cmath>
#include <cstdint>

#include "runner/study/expand.hpp"
#include "runner/study/study_cases.hpp"
#include "runner/study/study_reader.hpp"
#include "solver/case/mistyped_keys.hpp"

namespace capstan {
namespace {

using nlohmann::json;

/// 4.0 becomes 4 and -0.0 becomes 0, so that one study in two spellings is one document.
void spell_numbers_alike(json& value) {
  constexpr double kMaxWhole = 9007199254740992;  // 2^53: up to here a double holds every whole number
  if (value.is_structured())
    for (json& inner : value) spell_numbers_alike(inner);
  if (!value.is_number_float()) return;
  const double number = value;
  if (number == std::floor(number) && std::abs(number) <= kMaxWhole)
    value = static_cast<std::int64_t>(number);
}

/// A mistyped key becomes one issue, and the key that it was meant to be is not reported as missing.
Issues rename_mistyped_keys_of_study(json& document) {
  Issues issues =
      rename_mistyped_keys(document, {"name", "description", "base", "axes", "boundary", "refine"});
  for (const auto& [group, known] : {std::pair{"base", case_keys()}, std::pair{"axes", axis_parameters()},
                                     std::pair{"boundary", boundary_keys()}})
    if (document.contains(group)) {
      const Issues more = rename_mistyped_keys(document[group], known, std::string("/") + group);
      issues.insert(issues.end(), more.begin(), more.end());
    }
  return issues;
}

}  // namespace

json Study::asked_at(std::size_t point) const {
  json asked = document["base"];
  const AxisIndices indices = axis_indices(axes, point);
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    asked[axes[axis].parameter()] = axes[axis].value(indices[axis]);
  for (const char* key : {"until", "outputs"}) asked.erase(key);
  return asked;
}

ParsedStudy parse_study(const json& document) {
  ParsedStudy parsed;
  if (!document.is_object()) {
    parsed.issues.push_back({"", std::string("a study must be an object, is ") + document.type_name()});
    return parsed;
  }
  json alike = document;
  spell_numbers_alike(alike);
  parsed.issues = rename_mistyped_keys_of_study(alike);
  IssueCollector issues(parsed.issues);
  StudyParts parts = read_study_parts(alike, issues);
  if (parts.base) StudyCases(*parts.base, parts.invalid_axes, issues).expand(parts.study);
  if (parsed.issues.empty()) parsed.value = std::move(parts.study);
  limit_number(parsed.issues);
  return parsed;
}

ParsedStudy parse_study_text(std::string_view text) {
  ParsedJson json = parse_json(text);
  limit_number(json.issues);
  if (!json.value) return {std::nullopt, std::move(json.issues)};
  return parse_study(*json.value);
}

}  // namespace capstan
