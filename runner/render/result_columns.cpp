#include "runner/render/result_columns.hpp"

#include <algorithm>
#include <numbers>

#include "runner/study/axis.hpp"
#include "runner/study/shown_value.hpp"
#include "solver/case/choice.hpp"
#include "solver/case/parameters.hpp"
#include "solver/run_directory/history_line.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// The values of a point by the paths of their columns.
using Row = std::map<std::string, ordered_json>;

std::string item_text(const ordered_json& item) {
  const bool is_choice = item.is_object() && item.contains("reason");
  return is_choice ? in_words({item["key"], item["asked"], item["chosen"], item["reason"]})
                   : shown_value(item);
}

std::string list_text(const ordered_json& list) {
  std::string text;
  for (const ordered_json& item : list) text += (text.empty() ? "" : "; ") + item_text(item);
  return text;
}

/// The path of a column: parameters.fidelity.nodes in the JSON is the column fidelity.nodes.
std::string path_in(const std::string& group, const std::string& key) {
  return group.empty() || group == "parameters" ? key : group + "." + key;
}

void add_values(const ordered_json& object, const std::string& group, Row& row) {
  for (const auto& [key, value] : object.items()) {
    const std::string column = path_in(group, key);
    if (value.is_array())
      row[column] = list_text(value);
    else if (value.is_object() && group == "asked")  // the study's fidelity, as it was written
      row[column] = value.dump();
    else if (value.is_object())
      add_values(value, column, row);
    else if (!value.is_null())
      row[column] = value;
  }
}

Row row_of(const ordered_json& shown) {
  Row row;
  add_values(shown, "", row);
  return row;
}

bool is_parameter(const std::string& path) {
  return std::ranges::any_of(parameters(), [&](const Parameter& parameter) {
    return path_in(parameter.group, parameter.key) == path;
  });
}

/// The path without its first part. Paths in `until` and `outputs` keep it, because `kt` alone is the time
/// that a run has reached.
std::string short_name(const std::string& path) {
  return path.starts_with("until.") || path.starts_with("outputs.") ? path : path.substr(path.find('.') + 1);
}

std::string summary_name(const std::string& path) { return path == "error.Q" ? "error" : short_name(path); }

/// Columns that have a value only after the end of a run. If only unfinished runs lack a value, the column
/// does not count as varying.
bool is_known_at_the_end(const std::string& path) {
  return path == "trust.numerics_version" || path == "stop";
}

/// Numbers divided by `unit`, other values unchanged.
ordered_json in_unit(const ordered_json& value, double unit) {
  return value.is_number() && unit != 1 ? ordered_json(value.get<double>() / unit) : value;
}

using Names = std::initializer_list<std::string_view>;

/// \param group  start of the paths, such as "fidelity."
void add_columns(std::vector<std::string>& columns, std::string_view group, Names names) {
  for (const std::string_view name : names) columns.push_back(std::string(group) + std::string(name));
}

std::vector<std::string> make_known_columns() {
  std::vector<std::string> all;
  add_columns(all, "", {"id", "state", "motion", "message", "attempt"});
  add_columns(all, "", {"point", "same_as", "replaces", "crashes", "progress", "kt"});
  add_columns(all, "", {"stop", "explanation", "trust.warnings", "choices", "without_effect"});
  for (const Parameter& parameter : parameters()) all.push_back(path_in(parameter.group, parameter.key));
  for (const std::string_view parameter : axis_parameters()) add_columns(all, "asked.", {parameter});
  for (const Observable& observable : kObservables) add_columns(all, "final.", {observable.name});
  add_columns(all, "evidence.", {"n_theta", "n_psi", "r", "D_min", "turns", "theta_range", "margin"});
  add_columns(all, "", {"confirmed"});
  add_columns(all, "error.", {"Q", "D_xy", "theta", "period", "label_agrees", "unknown"});
  add_columns(all, "cost.", {"seconds", "steps", "flow_iterations", "peak_memory_mb"});
  add_columns(all, "trust.", {"numerics_version", "fluid", "bending"});
  add_columns(all, "trust.", {"volume_drift", "area_drift", "worst_flow_error", "left_out"});
  add_columns(all, "trust.surface.",
              {"largest_dihedral", "folded_edges", "smallest_angle", "smallest_wavelength"});
  add_columns(all, "trust.surface.", {"folded_from", "lost_from"});
  return all;
}

}  // namespace

const std::vector<std::string>& known_columns() {
  static const std::vector<std::string> columns = make_known_columns();
  return columns;
}

void ResultColumns::look_at(const ordered_json& cases) {
  for (const ordered_json& shown : cases) {
    ++points_;
    const Row row = row_of(shown);
    for (const auto& [path, value] : row) {
      Seen& seen = seen_.try_emplace(path, Seen{value, 0, false}).first->second;
      ++seen.count;
      seen.differs = seen.differs || seen.first != value;
      const auto asked = row.find("asked." + path);
      if (asked != row.end() && asked->second != value) resolved_otherwise_.insert(path);
    }
  }
}

bool ResultColumns::varies(const std::string& path) const {
  const auto found = seen_.find(path);
  return found != seen_.end() && (found->second.differs || found->second.count < points_);
}

bool ResultColumns::stands_in_summary(const std::string& path) const {
  if (is_known_at_the_end(path)) return seen_.contains(path) && seen_.at(path).differs;
  return is_parameter(path) && varies(path);
}

bool ResultColumns::has_words(const std::string& path) const {
  const auto found = seen_.find(path);
  return found != seen_.end() && (found->second.differs || found->second.first != "");
}

std::vector<ResultColumn> ResultColumns::all() const {
  std::vector<ResultColumn> columns;
  std::set<std::string> known;
  for (const std::string& path : known_columns()) {
    columns.push_back({path, path});
    known.insert(path);
  }
  for (const auto& [path, seen] : seen_)
    if (!known.contains(path)) columns.push_back({path, path});
  return columns;
}

std::vector<ResultColumn> ResultColumns::summary(const ordered_json& study) const {
  std::vector<ResultColumn> columns = {{"point", "point"}, {"case", "id"}};
  if (seen_.contains("same_as")) columns.push_back({"same as", "same_as"});
  std::set<std::string> axes;
  for (const ordered_json& axis : study["axes"]) {
    const std::string parameter = axis["parameter"];
    axes.insert(parameter);
    columns.push_back({parameter, "asked." + parameter});
    if (resolved_otherwise_.contains(parameter)) columns.push_back({"resolved " + parameter, parameter});
  }
  for (const std::string& path : known_columns())
    if (stands_in_summary(path) && !axes.contains(path)) columns.push_back({short_name(path), path});
  for (const char* path : {"state", "motion", "kt", "final.D_xy", "final.theta", "evidence.margin", "error.Q",
                           "confirmed", "message"})
    columns.push_back(path == std::string("final.theta") ? ResultColumn{"θ/π", path, std::numbers::pi}
                                                         : ResultColumn{summary_name(path), path});
  if (seen_.contains("where")) columns.push_back({"where", "where"});
  if (has_words("trust.warnings")) columns.push_back({"warnings", "trust.warnings"});
  return columns;
}

Table table_of(const ordered_json& cases, const std::vector<ResultColumn>& columns) {
  Table table;
  for (const ResultColumn& column : columns) {
    if (column.path.starts_with("asked.")) table.exact.insert(table.columns.size());
    table.columns.push_back(column.name);
  }
  for (const ordered_json& shown : cases) {
    const Row values = row_of(shown);
    auto& row = table.rows.emplace_back();
    for (const ResultColumn& column : columns) {
      const auto found = values.find(column.path);
      row.push_back(found == values.end() ? ordered_json() : in_unit(found->second, column.unit));
    }
  }
  return table;
}

}  // namespace capstan
