#include "solver/case/json_schema.hpp"

#include "solver/case/parameters.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// The default of the parameter; null if it depends on other parameters.
ordered_json default_of(const Parameter& parameter) {
  if (parameter.key == "fluid") return "auto";
  const bool depends_on_others = !parameter.required.empty() || parameter.group == "fidelity" ||
                                 parameter.key == "Re" || parameter.key == "at_most";
  return depends_on_others ? ordered_json() : parameter.value->write(Case{});
}

ordered_json schema_of(const Parameter& parameter) {
  ordered_json schema = {{"description", parameter.description}};
  schema.update(parameter.value->schema());
  if (ordered_json value = default_of(parameter); !value.is_null()) schema["default"] = std::move(value);
  return schema;
}

ordered_json properties_of(const std::string& group) {
  ordered_json properties = ordered_json::object();
  for (const Parameter& parameter : parameters())
    if (parameter.group == group) properties[parameter.key] = schema_of(parameter);
  return properties;
}

ordered_json object_with(ordered_json properties) {
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

ordered_json preset_reference() { return {{"$ref", "#/definitions/preset"}}; }

/// The name of a preset, or an object of settings that may start from one.
ordered_json fidelity_schema(const ParameterGroup& group) {
  ordered_json settings = {{"preset", preset_reference()}};
  settings.update(properties_of(group.key));
  return {{"description", group.description},
          {"oneOf", ordered_json::array({preset_reference(), object_with(std::move(settings))})},
          {"default", "standard"}};
}

ordered_json group_schema(const ParameterGroup& group) {
  if (group.key == "fidelity") return fidelity_schema(group);
  ordered_json schema = {{"description", group.description}};
  schema.update(object_with(properties_of(group.key)));
  return schema;
}

/// Parameters that every case must give.
ordered_json required_keys() {
  ordered_json keys = ordered_json::array();
  for (const Parameter& parameter : parameters())
    if (!parameter.required.empty() && parameter.conditions.empty()) keys.push_back(parameter.key);
  return keys;
}

}  // namespace

ordered_json case_schema() {
  ordered_json properties = properties_of("");
  for (const ParameterGroup& group : parameter_groups()) properties[group.key] = group_schema(group);
  ordered_json schema = {
      {"$schema", "http://json-schema.org/draft-07/schema#"},
      {"$id", "case.schema.json"},
      {"title", "Case"},
      {"description",
       "One run. Everything is dimensionless: radius 1, shear rate 1, ambient viscosity 1. Some rules stand "
       "in no "
       "schema: a parameter without effect (C with the neo-Hookean law) is refused, and so is a run with too "
       "many "
       "steps, records or shapes, or with a grid that is too large or too small for the capsule."},
      {"required", required_keys()}};
  schema.update(object_with(std::move(properties)));
  schema["definitions"] = {{"preset", {{"enum", preset_names()}}}};
  return schema;
}

}  // namespace capstan
