#include "solver/case/parameters.hpp"

#include <algorithm>

namespace capstan {

bool Parameter::has_effect(const Case& c) const {
  return std::ranges::all_of(conditions, [&](const Condition& condition) { return condition.holds(c); });
}

const Parameter* find_parameter(std::string_view key) {
  for (const Parameter& parameter : parameters())
    if (parameter.group.empty() && parameter.key == key) return &parameter;
  return nullptr;
}

const std::vector<std::string_view>& scalar_parameters() {
  static const std::vector<std::string_view> keys = [] {
    std::vector<std::string_view> scalars;
    for (const Parameter& parameter : parameters())
      if (parameter.group.empty()) scalars.push_back(parameter.key);
    return scalars;
  }();
  return keys;
}

const std::vector<std::string_view>& case_keys() {
  static const std::vector<std::string_view> keys = [] {
    std::vector<std::string_view> all = scalar_parameters();
    for (const ParameterGroup& group : parameter_groups()) all.push_back(group.key);
    return all;
  }();
  return keys;
}

nlohmann::ordered_json to_json(const Case& c) {
  nlohmann::ordered_json document;
  for (const Parameter& parameter : parameters()) {
    if (!parameter.has_effect(c)) continue;
    nlohmann::ordered_json& object = parameter.group.empty() ? document : document[parameter.group];
    object[parameter.key] = parameter.value->write(c);
  }
  return document;
}

}  // namespace capstan
