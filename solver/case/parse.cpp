#include "solver/case/parse.hpp"

#include <set>

#include "solver/case/case_reader.hpp"
#include "solver/case/limits.hpp"
#include "solver/case/mistyped_keys.hpp"

namespace capstan {
namespace {

using nlohmann::json;

/// A key without effect causes one issue only: issues with its value are dropped.
void drop_other_issues_of_keys_without_effect(Issues& issues) {
  std::set<std::string> without_effect;
  for (const Issue& issue : issues)
    if (issue.without_effect) without_effect.insert(issue.pointer);
  std::erase_if(issues, [&](const Issue& issue) {
    return !issue.without_effect && without_effect.contains(issue.pointer);
  });
}

}  // namespace

ParsedCase parse_case(const json& object) {
  ParsedCase parsed;
  if (!object.is_object()) {
    parsed.issues.push_back({"", std::string("a case must be an object, is ") + object.type_name()});
    return parsed;
  }
  json corrected = object;
  parsed.issues = rename_mistyped_keys(corrected, case_keys());
  const Case c = CaseReader(corrected, parsed.issues, parsed.choices).read();
  drop_other_issues_of_keys_without_effect(parsed.issues);
  if (parsed.issues.empty()) parsed.issues = limits_exceeded(c);
  if (parsed.issues.empty()) parsed.value = c;
  return parsed;
}

Issues drop_keys_without_effect(json& object) {
  Issues dropped;
  for (const Issue& issue : parse_case(object).issues) {
    if (!issue.without_effect) continue;
    const json::json_pointer key(issue.pointer);
    object[key.parent_pointer()].erase(key.back());
    dropped.push_back(issue);
  }
  return dropped;
}

}  // namespace capstan
