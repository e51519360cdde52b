#include "runner/results/export.hpp"

#include <algorithm>

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// What stands at the path of keys; null if anything on the way is missing.
ordered_json at(const ordered_json& object, std::initializer_list<std::string> keys) {
  const ordered_json* here = &object;
  for (const std::string& key : keys) {
    if (!here->is_object() || !here->contains(key)) return nullptr;
    here = &(*here)[key];
  }
  return *here;
}

/// The keys under `group` whose values are plain, over all cases, in the order of their first appearance.
std::vector<std::string> scalar_keys(const ordered_json& cases, const std::string& group) {
  std::vector<std::string> keys;
  for (const ordered_json& shown : cases) {
    const ordered_json inner = at(shown, {group});
    if (!inner.is_object()) continue;
    for (const auto& [key, value] : inner.items())
      if (!value.is_structured() && std::find(keys.begin(), keys.end(), key) == keys.end())
        keys.push_back(key);
  }
  return keys;
}

/// A study varies fidelity by name, a case holds its knobs: dx tells them apart.
ordered_json axis_value(const ordered_json& shown, const std::string& parameter) {
  return parameter == "fidelity" ? at(shown, {"parameters", "fidelity", "dx"})
                                 : at(shown, {"parameters", parameter});
}

}  // namespace

Table summary_table(const ordered_json& study, const ordered_json& cases) {
  Table table{{"case"}, {}};
  for (const ordered_json& axis : study["axes"]) {
    const std::string parameter = axis["parameter"];
    table.columns.push_back(parameter == "fidelity" ? "dx" : parameter);
  }
  for (const char* column : {"state", "motion", "kt", "D_xy", "theta", "margin", "message"})
    table.columns.emplace_back(column);
  for (const ordered_json& shown : cases) {
    auto& row = table.rows.emplace_back();
    row.push_back(shown["id"]);
    for (const ordered_json& axis : study["axes"]) row.push_back(axis_value(shown, axis["parameter"]));
    for (const char* key : {"state", "motion", "kt"}) row.push_back(shown[key]);
    for (const char* key : {"D_xy", "theta"}) row.push_back(at(shown, {"final", key}));
    row.push_back(at(shown, {"evidence", "margin"}));
    row.push_back(shown["message"]);
  }
  return table;
}

Table full_table(const ordered_json& cases) {
  Table table{{"id", "state", "motion", "message", "attempt"}, {}};
  for (const ordered_json& shown : cases) {
    auto& row = table.rows.emplace_back();
    for (const std::string& key : table.columns) row.push_back(shown[key]);
  }
  for (const char* group : {"parameters", "final", "evidence", "cost"})
    for (const std::string& key : scalar_keys(cases, group)) {
      table.columns.push_back(group == std::string("parameters") ? key : std::string(group) + "." + key);
      for (std::size_t i = 0; i < cases.size(); ++i) table.rows[i].push_back(at(cases[i], {group, key}));
    }
  return table;
}

Table history_table(const ordered_json& history) {
  Table table;
  for (const auto& [name, values] : history.items()) {
    table.columns.push_back(name);
    table.rows.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) table.rows[i].push_back(values[i]);
  }
  return table;
}

}  // namespace capstan
