#include "runner/study/study_schema.hpp"

#include <string>
#include <string_view>

#include "runner/study/axis.hpp"
#include "runner/study/study_boundary.hpp"
#include "solver/case/parameters.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

ordered_json property_of_case(std::string_view key) {
  return {{"$ref", "case.schema.json#/properties/" + std::string(key)}};
}

/// The schema of an axis: a list of values or, for a parameter that is a number, an evenly spaced range.
ordered_json axis_schema(std::string_view key) {
  ordered_json list = {{"type", "array"}, {"minItems", 1}, {"items", property_of_case(key)}};
  if (!takes_numbers(key)) return list;
  return {{"oneOf", ordered_json::array({std::move(list), {{"$ref", "#/definitions/range"}}})}};
}

ordered_json object_with(const char* description, ordered_json properties) {
  return {{"description", description},
          {"type", "object"},
          {"additionalProperties", false},
          {"properties", std::move(properties)}};
}

ordered_json base_schema() {
  ordered_json properties;
  for (const std::string_view key : case_keys()) properties[std::string(key)] = property_of_case(key);
  return object_with("The parameters that all cases share.", std::move(properties));
}

ordered_json axes_schema() {
  ordered_json properties;
  for (const std::string_view key : axis_parameters()) properties[std::string(key)] = axis_schema(key);
  return object_with("The parameters that vary; none of them stands in the base.", std::move(properties));
}

ordered_json range_schema() {
  ordered_json schema = object_with(
      "Evenly spaced values, both ends included; those between are rounded to six digits, or to as many as "
      "tell "
      "them apart.",
      {{"from", {{"type", "number"}}},
       {"to", {{"type", "number"}}},
       {"count", {{"type", "integer"}, {"minimum", 2}, {"maximum", 1000000}}},
       {"scale",
        {{"description", "On a log scale both ends are > 0."},
         {"enum", {"linear", "log"}},
         {"default", "linear"}}}});
  schema["required"] = {"from", "to", "count"};
  return schema;
}

/// The parameters that are numbers can be searched along.
ordered_json searched_parameters() {
  ordered_json names = ordered_json::array();
  for (const std::string_view key : scalar_parameters())
    if (takes_numbers(key)) names.push_back(key);
  return names;
}

ordered_json refine_schema() {
  ordered_json sides;
  for (const ordered_json& key : searched_parameters())
    sides[key.get<std::string>()] = {{"type", "number"}, {"exclusiveMinimum", 0}};
  ordered_json schema = object_with(
      "Two of the axes, with the sides of the smallest cells: where the motions at the corners of a cell of "
      "the "
      "grid differ, it is divided until its sides are at most these.",
      std::move(sides));
  schema["minProperties"] = schema["maxProperties"] = 2;
  return schema;
}

ordered_json boundary_schema() {
  ordered_json rows;
  for (const std::string_view key : axis_parameters()) rows[std::string(key)] = axis_schema(key);
  ordered_json schema = object_with(
      "Instead of axes: where tumbling ends and tank-treading begins along one parameter. Each row is first "
      "computed at evenly spaced values; further ones follow where the motion changes.",
      {{"along", {{"description", "The parameter that is searched."}, {"enum", searched_parameters()}}},
       {"between",
        {{"description", "The two ends of the searched range, 0 < first < second."},
         {"type", "array"},
         {"minItems", 2},
         {"maxItems", 2},
         {"items", {{"type", "number"}, {"exclusiveMinimum", 0}}}}},
       {"for", object_with("The parameters that vary from row to row.", std::move(rows))},
       {"tolerance",
        {{"description", "Relative distance of the two points around the boundary."},
         {"type", "number"},
         {"minimum", StudyBoundary::kMinTolerance},
         {"maximum", StudyBoundary::kMaxTolerance},
         {"default", StudyBoundary::kTolerance}}},
       {"explore",
        {{"description",
          "Number of first values of each row, evenly spaced in the logarithm. An island of another motion "
          "that is wider than their distance is not missed."},
         {"type", "integer"},
         {"minimum", StudyBoundary::kMinExplored},
         {"maximum", StudyBoundary::kMaxExplored},
         {"default", StudyBoundary::kExplored}}}});
  schema["required"] = {"along", "between"};
  return schema;
}

}  // namespace

ordered_json study_schema() {
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"$id", "study.schema.json"},
          {"title", "Study"},
          {"description",
           "A base case and the axes along which it varies; the cases are the product of the axes, at most "
           "10,000. Or a base case and the boundary that is sought; then there are no axes."},
          {"type", "object"},
          {"additionalProperties", false},
          {"required", {"name", "base"}},
          {"properties",
           {{"name",
             {{"description", "The study's id begins with it."},
              {"type", "string"},
              {"pattern", "^[A-Za-z0-9_-]{1,40}$"}}},
            {"description", {{"type", "string"}}},
            {"base", base_schema()},
            {"axes", axes_schema()},
            {"boundary", boundary_schema()},
            {"refine", refine_schema()}}},
          {"definitions", {{"range", range_schema()}}}};
}

}  // namespace capstan
