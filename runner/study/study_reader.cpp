#include "runner/study/study_reader.hpp"

#include <algorithm>
#include <cctype>

#include "runner/study/study_base.hpp"

namespace capstan {
namespace {

using nlohmann::json;

std::string pointer_to(const std::string& object, const std::string& key) {
  return (json::json_pointer(object) / key).to_string();
}

/// The name is a part of the study's id, which people type.
std::string read_name(const json& document, IssueCollector& issues) {
  constexpr std::size_t kMaxLength = 40;
  const json name = document.value("name", json());
  const std::string text = name.is_string() ? name.get<std::string>() : "";
  const auto allowed = [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '-' || c == '_'); };
  if (text.empty() || text.size() > kMaxLength || !std::ranges::all_of(text, allowed))
    issues.add("/name", "must be 1 to 40 letters, digits, '-' or '_'");
  return text;
}

std::string read_description(const json& document, IssueCollector& issues) {
  const json description = document.value("description", json(""));
  if (description.is_string()) return description.get<std::string>();
  issues.add("/description", std::string("must be text, is ") + description.type_name());
  return "";
}

void refuse_other_axes(const json& given, IssueCollector& issues) {
  const auto& known = axis_parameters();
  std::string names;
  for (const std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
  for (const auto& [key, value] : given.items())
    if (std::ranges::find(known, key) == known.end())
      issues.add(pointer_to("/axes", key), "cannot be an axis; these can: " + names);
}

void read_axes(const json& document, StudyParts& parts, IssueCollector& issues) {
  const json given = document.value("axes", json::object());
  if (!given.is_object())
    return issues.add("/axes", std::string("must be an object, is ") + given.type_name());
  for (const std::string_view name : axis_parameters()) {
    const std::string parameter(name);
    if (!given.contains(parameter)) continue;
    if (auto axis = read_axis(parameter, given[parameter], "/axes/" + parameter, issues.list()))
      parts.study.axes.push_back(std::move(*axis));
    else
      parts.invalid_axes.insert(parameter);
  }
  refuse_other_axes(given, issues);
}

void read_boundary_and_axes(const json& document, StudyParts& parts, IssueCollector& issues) {
  if (document.contains("axes"))
    issues.add("/axes", "a study that seeks a boundary has no axes: its rows are in boundary.for");
  BoundaryParts read = read_boundary(document["boundary"], issues);
  parts.study.boundary = std::move(read.boundary);
  parts.study.axes = std::move(read.axes);
  parts.invalid_axes.insert(read.invalid_axes.begin(), read.invalid_axes.end());
}

/// Keys of the base that the boundary varies.
void refuse_keys_of_boundary(const StudyParts& parts, const json& base, IssueCollector& issues) {
  for (const Axis& axis : parts.study.axes)
    if (base.contains(axis.parameter()))
      issues.add(pointer_to("/base", axis.parameter()), "is varied by the boundary, too");
}

/// Keys of the base that are also keys of the axes, valid or not.
void refuse_keys_of_axes(const json& document, const json& base, IssueCollector& issues) {
  const auto axes = document.find("axes");
  if (axes == document.end() || !axes->is_object()) return;
  for (const auto& [parameter, values] : axes->items())
    if (base.contains(parameter)) issues.add(pointer_to("/base", parameter), "is an axis, too");
}

const json* read_base(const json& document, IssueCollector& issues) {
  const auto base = document.find("base");
  if (base == document.end())
    issues.add("/base", "is missing: the case that the axes vary");
  else if (!base->is_object())
    issues.add("/base", std::string("must be an object, is ") + base->type_name());
  if (issues.has_issue("/base")) return nullptr;
  refuse_keys_of_axes(document, *base, issues);
  return &*base;
}

void refuse_unknown_keys(const json& document, IssueCollector& issues) {
  static const std::set<std::string> known = {"name", "description", "base", "axes", "boundary", "refine"};
  for (const auto& [key, value] : document.items())
    if (!known.contains(key)) issues.add(pointer_to("", key), "unknown key");
}

}  // namespace

StudyParts read_study_parts(const json& document, IssueCollector& issues) {
  StudyParts parts;
  parts.study.document = document;
  parts.study.name = read_name(document, issues);
  parts.study.description = read_description(document, issues);
  if (document.contains("boundary"))
    read_boundary_and_axes(document, parts, issues);
  else
    read_axes(document, parts, issues);
  refuse_unknown_keys(document, issues);
  if (document.contains("refine"))
    parts.study.refinement = read_refinement(document["refine"], parts.study.axes, issues);
  const bool is_incomplete = document.contains("boundary") && !parts.study.boundary;
  if (read_base(document, issues) && !is_incomplete) parts.base = base_of(document);
  if (parts.base && parts.study.boundary) refuse_keys_of_boundary(parts, *parts.base, issues);
  return parts;
}

}  // namespace capstan
