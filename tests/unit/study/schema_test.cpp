// The JSON schemas accept what the code that reads studies and cases accepts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "runner/study/study.hpp"
#include "runner/study/study_schema.hpp"
#include "solver/case/json_schema.hpp"
#include "solver/strain_laws/strain_law.hpp"
#include "tests/support/source_directory.hpp"

namespace capstan {
namespace {

using nlohmann::json;

json schema(const std::string& name) { return name == "case" ? case_schema() : study_schema(); }

std::set<std::string> keys(const json& object) {
  std::set<std::string> all;
  for (const auto& [key, value] : object.items()) all.insert(key);
  return all;
}

std::set<std::string> keys_of_a_case() {
  std::set<std::string> all(scalar_parameters().begin(), scalar_parameters().end());
  all.insert({"until", "fidelity", "outputs"});
  return all;
}

/// A case in which every key but `aspect` has an effect. Each value can be set to its bounds, one at a time,
/// without making the run impossible.
const json kCase =
    json::parse(R"({"shape": "biconcave", "law": "skalak", "C": 5, "Ca": 0.75, "V": 4, "Re": 0.05,
  "E_b": 0.015, "bending": "variational", "c0": 0, "fluid": "quasisteady", "until": {"kt": 0.05, "classified": true},
  "fidelity": {"precision": "double", "kdt": 0.02}})");

std::vector<std::string> pointers_of_issues_with(const std::string& pointer, const json& value) {
  json object = kCase;
  if (pointer == "/aspect") object["shape"] = value < 1 ? "oblate" : "prolate";
  if (pointer == "/Re")
    object["fluid"] = "auto", object["fidelity"] = value < 0.1 ? json("fast") : json({{"box", 6.4}});
  if (pointer == "/until/at_most") object["until"]["kt"] = 1e-6;
  if (pointer == "/fidelity/tolerance") object["fidelity"]["precision"] = "double";
  object[json::json_pointer(pointer)] = value;
  std::vector<std::string> pointers;
  for (const Issue& issue : parse_case(object).issues) pointers.push_back(issue.pointer);
  return pointers;
}

bool accepts(const std::string& pointer, const json& value) {
  const auto issues = pointers_of_issues_with(pointer, value);
  return std::find(issues.begin(), issues.end(), pointer) == issues.end();
}

/// The properties of a case and of the objects inside it, with their pointers.
std::vector<std::pair<std::string, json>> all_properties() {
  const json properties = schema("case")["properties"];
  std::vector<std::pair<std::string, json>> all;
  for (const auto& [key, property] : properties.items()) {
    all.emplace_back("/" + key, property);
    const json inner = key == "fidelity" ? property["oneOf"][1] : property;
    const json nested = inner.value("properties", json::object());
    for (const auto& [inner_key, inner_property] : nested.items())
      all.emplace_back("/" + key + "/" + inner_key, inner_property);
  }
  return all;
}

TEST(Schema, CaseHasTheKeysOfTheCode) { EXPECT_EQ(keys(schema("case")["properties"]), keys_of_a_case()); }

TEST(Schema, ObjectsInACaseHaveTheKeysThatTheCodeWritesOut) {
  const json written = to_json(parse_case(kCase).value.value());
  const json properties = schema("case")["properties"];
  EXPECT_EQ(keys(properties["until"]["properties"]), keys(written["until"]));
  EXPECT_EQ(keys(properties["outputs"]["properties"]), keys(written["outputs"]));
  std::set<std::string> knobs = keys(written["fidelity"]);
  knobs.insert({"preset", "error"});
  EXPECT_EQ(keys(properties["fidelity"]["oneOf"][1]["properties"]), knobs);
}

TEST(Schema, BoundsAreThoseOfTheCode) {
  for (const auto& [pointer, property] : all_properties()) {
    if (property.contains("minimum")) {
      EXPECT_TRUE(accepts(pointer, property["minimum"])) << pointer;
      EXPECT_FALSE(accepts(pointer, property["minimum"].get<double>() - 1e-9)) << pointer;
    }
    if (property.contains("exclusiveMinimum")) {
      EXPECT_FALSE(accepts(pointer, property["exclusiveMinimum"])) << pointer;
    }
    if (property.contains("maximum")) {
      EXPECT_TRUE(accepts(pointer, property["maximum"])) << pointer;
      EXPECT_FALSE(accepts(pointer, property["maximum"].get<double>() * 1.001)) << pointer;
    }
  }
}

TEST(Schema, WordsAreThoseOfTheCode) {
  for (const auto& [pointer, property] : all_properties()) {
    const json words = property.value("enum", json::array());
    for (const json& word : words) EXPECT_TRUE(accepts(pointer, word)) << pointer << " " << word;
    EXPECT_TRUE(words.empty() || !accepts(pointer, "no such word")) << pointer;
  }
}

TEST(Schema, PresetsAreThoseOfTheCode) {
  std::set<std::string> names;
  for (const FidelityPreset& preset : fidelity_presets()) names.emplace(preset.name);
  EXPECT_EQ(schema("case")["definitions"]["preset"]["enum"].get<std::set<std::string>>(), names);
}

TEST(Schema, DefaultsAreThoseOfTheCode) {
  json spelt_out = {{"Ca", 0.1}};
  for (const auto& [pointer, property] : all_properties())
    if (property.contains("default") && pointer != "/bending" && pointer != "/c0")
      spelt_out[json::json_pointer(pointer)] = property["default"];
  EXPECT_EQ(parse_case(spelt_out).value.value(), parse_case({{"Ca", 0.1}}).value.value());
}

TEST(Schema, StudyHasTheKeysOfTheCode) {
  const json study = schema("study");
  EXPECT_EQ(keys(study["properties"]),
            (std::set<std::string>{"name", "description", "base", "axes", "boundary", "refine"}));
  EXPECT_EQ(keys(study["properties"]["base"]["properties"]), keys_of_a_case());
  const auto& axes = axis_parameters();
  EXPECT_EQ(keys(study["properties"]["axes"]["properties"]), std::set<std::string>(axes.begin(), axes.end()));
}

TEST(Schema, BoundaryHasTheKeysOfTheCode) {
  const json boundary = schema("study")["properties"]["boundary"];
  const auto& expected = boundary_keys();
  EXPECT_EQ(keys(boundary["properties"]), std::set<std::string>(expected.begin(), expected.end()));
  for (const json& along : boundary["properties"]["along"]["enum"]) {
    const json document = {
        {"name", "b"}, {"base", json::object()}, {"boundary", {{"along", along}, {"between", {1, 2}}}}};
    for (const Issue& issue : parse_study(document).issues)
      EXPECT_NE(issue.pointer, "/boundary/along") << along;
  }
}

TEST(Schema, EveryStudyOfTheRepositoryIsValid) {
  for (const auto& folder : std::filesystem::directory_iterator(source_directory() / "studies")) {
    const std::filesystem::path file = folder.path() / "study.json";
    if (!std::filesystem::exists(file)) continue;
    const ParsedStudy parsed = parse_study(json::parse(std::ifstream(file)));
    EXPECT_TRUE(parsed.value) << file;
  }
}

TEST(Schema, EveryValueIsDescribed) {
  for (const auto& [pointer, property] : all_properties())
    EXPECT_TRUE(property.contains("description") || pointer == "/fidelity/preset") << pointer;
}

TEST(Schema, NamesEachStrainLawWithItsModulus) {
  const std::string description = schema("case")["properties"]["law"]["description"];
  for (const StrainLaw& law : strain_laws())
    EXPECT_THAT(description,
                ::testing::HasSubstr(std::string(law.name) + " (" + std::string(law.modulus) + ")"));
}

TEST(Schema, RangeHasTheKeysOfTheCode) {
  const json range = schema("study")["definitions"]["range"];
  json document = {{"name", "range"},
                   {"base", json::object()},
                   {"axes", {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", 3}}}}}};
  for (const json& key : range["required"]) {
    const std::string required = key;
    json without = document;
    without["axes"]["Ca"].erase(required);
    EXPECT_EQ(parse_study(without).issues.at(0).pointer, "/axes/Ca/" + required);
  }
  for (const json& scale : range["properties"]["scale"]["enum"]) {
    document["axes"]["Ca"]["scale"] = scale;
    EXPECT_TRUE(parse_study(document).value) << scale;
  }
}

}  // namespace
}  // namespace capstan
