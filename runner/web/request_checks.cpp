#include "runner/web/request_checks.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "runner/web/listed.hpp"

namespace capstan {
namespace {

const QueryParameter* find(std::span<const QueryParameter> known, const std::string& name) {
  for (const QueryParameter& each : known)
    if (each.name == name) return &each;
  return nullptr;
}

std::string names_of(std::span<const QueryParameter> parameters) {
  std::vector<std::string_view> names;
  for (const QueryParameter& parameter : parameters) names.push_back(parameter.name);
  return listed(names);
}

std::string issue_of_unknown(std::span<const QueryParameter> known) {
  return known.empty() ? "is unknown: there are no parameters here"
                       : "is unknown; there are: " + names_of(known);
}

std::string issue_of(const QueryParameter& parameter, const std::string& value, bool is_repeated) {
  if (is_repeated && !parameter.may_repeat) return "stands twice";
  return value.empty() ? "has no value" : parameter.issue_of(value);
}

}  // namespace

Issues check_query(std::span<const QueryParameter> known, const httplib::Params& query) {
  Issues issues;
  const std::string* previous = nullptr;
  for (const auto& [name, value] : query) {
    const QueryParameter* const parameter = find(known, name);
    const bool is_repeated = previous && *previous == name;
    const std::string issue = parameter ? issue_of(*parameter, value, is_repeated) : issue_of_unknown(known);
    if (!issue.empty()) issues.push_back({name, issue});
    previous = &name;
  }
  return issues;
}

Issues check_body(std::span<const std::string_view> keys, const std::string& body) {
  if (body.find_first_not_of(" \t\r\n") == body.npos) return {};
  const ParsedJson parsed = parse_json(body);
  if (!parsed.value) return parsed.issues;
  if (!parsed.value->is_object())
    return {{"", std::string("must be an object, is ") + parsed.value->type_name()}};
  Issues issues;
  for (const auto& [key, value] : parsed.value->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      issues.push_back(
          {(nlohmann::json::json_pointer() / key).to_string(),
           keys.empty() ? "unknown key; send no body" : "unknown key; there are: " + listed(keys)});
  return issues;
}

}  // namespace capstan
