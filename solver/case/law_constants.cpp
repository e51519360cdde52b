#include "solver/case/law_constants.hpp"

#include <algorithm>

#include "solver/strain_laws/strain_law.hpp"

namespace capstan {
namespace {

/// Index of a constant in StrainLaw::constants; nothing if the law does not have it.
std::optional<std::size_t> index_of(const std::string& key, const StrainLaw& law) {
  for (std::size_t i = 0; i < law.constants.size(); ++i)
    if (law.constants[i].key == key) return i;
  return std::nullopt;
}

/// The laws that have the constant; there is at least one.
std::vector<const StrainLaw*> laws_with(const std::string& key) {
  std::vector<const StrainLaw*> laws;
  for (const StrainLaw& law : strain_laws())
    if (index_of(key, law)) laws.push_back(&law);
  return laws;
}

/// "skalak law", "skalak and mooney laws"
std::string names_of(const std::vector<const StrainLaw*>& laws) {
  std::string names;
  for (const StrainLaw* law : laws)
    names += (names.empty() ? "" : law == laws.back() ? " and " : ", ") + std::string(law->name);
  return names + (laws.size() == 1 ? " law" : " laws");
}

const LawConstant& constant_of(const StrainLaw& law, const std::string& key) {
  return law.constants[*index_of(key, law)];
}

/// Description of the constant. Laws may describe it differently: each description is given once.
std::string description_of(const std::string& key, const std::vector<const StrainLaw*>& laws) {
  std::vector<std::string> texts;
  for (const StrainLaw* law : laws) {
    const std::string text(constant_of(*law, key).description);
    if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
  }
  std::string description;
  for (const std::string& text : texts) description += (description.empty() ? "" : ", or ") + text;
  return description;
}

std::shared_ptr<const ParameterValue> value_of(const std::string& key,
                                               const std::vector<const StrainLaw*>& laws) {
  const auto place = [key](Case& c) {
    const auto index = index_of(key, *c.law);
    return index ? &c.law_constants[*index] : nullptr;
  };
  const auto range_in = [key](const Case& c) -> std::optional<Range> {
    if (!index_of(key, *c.law)) return std::nullopt;
    return Range{constant_of(*c.law, key).min, constant_of(*c.law, key).max};
  };
  Range whole = {constant_of(*laws.front(), key).min, constant_of(*laws.front(), key).max};
  for (const StrainLaw* law : laws) {
    whole.min = std::min(whole.min, constant_of(*law, key).min);
    whole.max = std::max(whole.max, constant_of(*law, key).max);
  }
  return std::make_shared<NumberValue>(place, range_in, whole);
}

Parameter constant_parameter(const std::string& key) {
  const std::vector<const StrainLaw*> laws = laws_with(key);
  const std::string description = description_of(key, laws), names = names_of(laws);
  const Condition law_has_it = {
      [key](const Case& c) { return index_of(key, *c.law).has_value(); },
      "only the " + names + (laws.size() == 1 ? " has" : " have") + " the constant " + key, "law"};
  return {.key = key,
          .value = value_of(key, laws),
          .conditions = {law_has_it},
          .description = description + "; required for the " + names + ".",
          .required = description};
}

}  // namespace

Parameter strain_law_parameter() {
  std::vector<std::string> names;
  std::string description = "Strain law of the membrane, which also says what the modulus E_s of Ca is: ";
  for (const StrainLaw& law : strain_laws()) {
    description +=
        (names.empty() ? "" : ", ") + std::string(law.name) + " (" + std::string(law.modulus) + ")";
    names.emplace_back(law.name);
  }
  const auto set = [](Case& c, std::string_view name) {
    c.law = find_strain_law(name);
    c.law_constants.assign(c.law->constants.size(), 0);
  };
  const auto get = [](const Case& c) { return c.law->name; };
  return {
      .key = "law", .value = std::make_shared<WordValue>(names, set, get), .description = description + "."};
}

std::vector<Parameter> law_constant_parameters() {
  std::vector<std::string> keys;
  for (const StrainLaw& law : strain_laws())
    for (const LawConstant& constant : law.constants)
      if (std::ranges::find(keys, constant.key) == keys.end()) keys.emplace_back(constant.key);
  std::vector<Parameter> parameters;
  parameters.reserve(keys.size());
  for (const std::string& key : keys) parameters.push_back(constant_parameter(key));
  return parameters;
}

}  // namespace capstan
