#include "runner/study/study_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "solver/case/parameters.hpp"

namespace capstan {
namespace {

using nlohmann::json;

std::string names_of_numbers() {
  std::string names;
  for (const std::string_view name : scalar_parameters())
    if (takes_numbers(name)) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

/// "" if it has an issue.
std::string read_along(const json& given, IssueCollector& issues) {
  const json along = given.value("along", json());
  if (along.is_string() && takes_numbers(along.get<std::string>())) return along;
  issues.add("/boundary/along", "must be one of: " + names_of_numbers());
  return "";
}

bool is_positive(const json& number) {
  return number.is_number() && std::isfinite(number.get<double>()) && number.get<double>() > 0;
}

/// The two ends; equal if they have an issue.
std::pair<double, double> read_between(const json& given, IssueCollector& issues) {
  const json between = given.value("between", json());
  const bool is_pair =
      between.is_array() && between.size() == 2 && is_positive(between[0]) && is_positive(between[1]);
  if (is_pair && between[0].get<double>() < between[1].get<double>()) return {between[0], between[1]};
  issues.add("/boundary/between",
             "must be the two ends of the searched range, as [0.05, 1]: 0 < first < second");
  return {1, 1};
}

double read_number(const json& given, const char* key, double usual, double min, double max, bool is_whole,
                   IssueCollector& issues) {
  const json number = given.value(key, json(usual));
  if (number.is_number() && number >= min && number <= max &&
      (!is_whole || number == std::floor(number.get<double>())))
    return number;
  issues.add(std::string("/boundary/") + key, std::string("must be a ") + (is_whole ? "whole " : "") +
                                                  "number >= " + json(min).dump() +
                                                  " and <= " + json(max).dump());
  return usual;
}

/// The values of the rows.
void read_rows(const json& given, const std::string& along, BoundaryParts& parts, IssueCollector& issues) {
  const std::string place = "/boundary/for";
  const json rows = given.value("for", json::object());
  if (!rows.is_object()) return issues.add(place, "must be an object, as {\"V\": [1, 2, 4]}");
  for (const auto& [key, values] : rows.items())
    if (std::ranges::find(axis_parameters(), key) == axis_parameters().end())
      issues.add((json::json_pointer(place) / key).to_string(), "cannot vary from row to row");
  for (const std::string_view name : axis_parameters()) {
    const std::string parameter(name), pointer = place + "/" + parameter;
    if (!rows.contains(parameter)) continue;
    if (parameter == along) {
      issues.add(pointer, "is searched along, so it cannot be fixed in the rows");
    } else if (auto axis = read_axis(parameter, rows[parameter], pointer, issues.list())) {
      parts.axes.push_back(std::move(*axis));
    } else {
      parts.invalid_axes.push_back(parameter);
    }
  }
}

/// In the order of axis_parameters().
void sort(std::vector<Axis>& axes) {
  const auto place = [](const Axis& axis) {
    return std::ranges::find(axis_parameters(), axis.parameter()) - axis_parameters().begin();
  };
  std::ranges::sort(axes, [&](const Axis& a, const Axis& b) { return place(a) < place(b); });
}

void refuse_unknown_boundary_keys(const json& given, IssueCollector& issues) {
  for (const auto& [key, value] : given.items())
    if (std::ranges::find(boundary_keys(), key) == boundary_keys().end())
      issues.add((json::json_pointer("/boundary") / key).to_string(), "unknown key");
}

}  // namespace

double StudyBoundary::explored_gap() const {
  return std::pow(search.to / search.from, 1. / (explored - 1)) - 1;
}

const std::vector<std::string_view>& boundary_keys() {
  static const std::vector<std::string_view> keys = {"along", "between", "for", "tolerance", "explore"};
  return keys;
}

BoundaryParts read_boundary(const json& given, IssueCollector& issues) {
  BoundaryParts parts;
  if (!given.is_object()) {
    issues.add("/boundary", std::string("must be an object, is ") + given.type_name());
    return parts;
  }
  StudyBoundary boundary;
  boundary.along = read_along(given, issues);
  std::tie(boundary.search.from, boundary.search.to) = read_between(given, issues);
  boundary.search.tolerance =
      read_number(given, "tolerance", StudyBoundary::kTolerance, StudyBoundary::kMinTolerance,
                  StudyBoundary::kMaxTolerance, false, issues);
  boundary.explored = int(read_number(given, "explore", StudyBoundary::kExplored, StudyBoundary::kMinExplored,
                                      StudyBoundary::kMaxExplored, true, issues));
  read_rows(given, boundary.along, parts, issues);
  refuse_unknown_boundary_keys(given, issues);
  for (const Axis& axis : parts.axes) boundary.rows_of.push_back(axis.parameter());
  if (boundary.along.empty()) return parts;
  if (boundary.search.from < boundary.search.to)
    parts.axes.emplace_back(
        boundary.along, AxisRange{boundary.search.from, boundary.search.to, double(boundary.explored), true},
        "/boundary/between");
  else
    parts.invalid_axes.push_back(boundary.along);
  sort(parts.axes);
  parts.boundary = std::move(boundary);
  return parts;
}

std::optional<StudyBoundary> boundary_of(const json& document) {
  if (!document.contains("boundary")) return std::nullopt;
  Issues issues;
  IssueCollector collector(issues);
  return read_boundary(document["boundary"], collector).boundary;
}

}  // namespace capstan
