#include "solver/case/mistyped_keys.hpp"

#include <algorithm>

#include "solver/case/nearest_word.hpp"

namespace capstan {
namespace {

using nlohmann::json;

std::vector<std::string> keys_not_in(const json& object, const std::vector<std::string_view>& known) {
  std::vector<std::string> missing;
  for (const std::string_view key : known)
    if (!object.contains(key)) missing.emplace_back(key);
  return missing;
}

std::vector<std::string> unknown_keys(const json& object, const std::vector<std::string_view>& known) {
  std::vector<std::string> unknown;
  for (const auto& [key, value] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end()) unknown.push_back(key);
  return unknown;
}

}  // namespace

Issues rename_mistyped_keys(json& object, const std::vector<std::string_view>& known,
                            const std::string& pointer) {
  Issues issues;
  if (!object.is_object()) return issues;
  for (const std::string& key : unknown_keys(object, known)) {
    const auto meant = nearest_word(key, keys_not_in(object, known));
    if (!meant) continue;
    issues.push_back(
        {(json::json_pointer(pointer) / key).to_string(), "unknown key; did you mean \"" + *meant + "\"?"});
    json value = std::move(object[key]);
    object.erase(key);
    object[*meant] = std::move(value);
  }
  return issues;
}

}  // namespace capstan
