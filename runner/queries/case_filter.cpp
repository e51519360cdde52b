#include "runner/queries/case_filter.hpp"

#include <algorithm>

#include "runner/queries/typed_value.hpp"

namespace capstan {

using nlohmann::json;

std::string wanted_word(const CaseFilter& filter, const std::string& key) {
  const auto found =
      std::find_if(filter.begin(), filter.end(), [&](const auto& each) { return each.first == key; });
  return found == filter.end() ? "" : found->second;
}

ParameterFilter::ParameterFilter(const CaseFilter& filter, const json& axes) {
  for (const auto& [key, text] : filter) {
    if (key == "state" || key == "motion") continue;
    Condition& condition = conditions_.emplace_back(Condition{key, text, false, std::nullopt});
    for (const json& axis : axes) {
      if (axis["parameter"] != key) continue;
      const std::vector<json> values = axis["values"];
      condition.is_axis = true;
      if (const auto place = find_typed(values, text)) condition.value = values[*place];
    }
  }
}

bool ParameterFilter::matches(const std::string& asked_text, const std::string& document) const {
  if (conditions_.empty()) return true;
  const json asked = json::parse(asked_text);
  const auto is_met = [&](const Condition& condition) {
    if (condition.is_axis) return condition.value && asked.value(condition.key, json()) == *condition.value;
    if (asked.contains(condition.key) && means(condition.text, asked[condition.key])) return true;
    return means(condition.text, json::parse(document).value(condition.key, json()));
  };
  return std::all_of(conditions_.begin(), conditions_.end(), is_met);
}

}  // namespace capstan
