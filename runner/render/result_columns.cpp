#include "runner/render/result_columns.hpp"

#include <algorithm>
#include <numbers>

#include "runner/study/axis.hpp"
#include "runner/study/shown_value.hpp"
#include "solver/case/choice.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

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

/// "parameters.fidelity.nodes" is the column fidelity.nodes.
std::string column_at(const std::string& group, const std::string& key) {
  return group.empty() || group == "parameters" ? key : group + "." + key;
}

void add_values(const ordered_json& object, const std::string& group, Row& row) {
  for (const auto& [key, value] : object.items()) {
    const std::string column = column_at(group, key);
    if (value.is_array())
      row[column] = list_text(value);
    else if (value.is_object() && group == "asked")  // the knobs of a fidelity, as they were written
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
  const auto& scalars = axis_parameters();
  if (std::find(scalars.begin(), scalars.end(), path) != scalars.end()) return true;
  return path.starts_with("until.") || path.starts_with("fidelity.") || path.starts_with("outputs.");
}

/// Of a path such as fidelity.nodes the last word; until.kt is named in full, because kt is how far a run is.
std::string short_name(const std::string& path) {
  return path.starts_with("until.") || path.starts_with("outputs.") ? path : path.substr(path.find('.') + 1);
}

/// The solver's numerics, and how the runs ended: unknown before the end of a run.
bool is_known_at_the_end(const std::string& path) {
  return path == "trust.numerics_version" || path == "stop";
}

/// Of words and of the unit 1 the value itself.
ordered_json in_unit(const ordered_json& value, double unit) {
  return value.is_number() && unit != 1 ? ordered_json(value.get<double>() / unit) : value;
}

}  // namespace

const std::vector<std::string>& known_columns() {
  static const std::vector<std::string> columns = {"id",
                                                   "state",
                                                   "motion",
                                                   "message",
                                                   "attempt",  //
                                                   "point",
                                                   "same_as",
                                                   "replaces",
                                                   "crashes",
                                                   "progress",
                                                   "kt",
                                                   "stop",
                                                   "explanation",
                                                   "trust.warnings",
                                                   "choices",
                                                   "without_effect",  //
                                                   "shape",
                                                   "aspect",
                                                   "law",
                                                   "C",
                                                   "Ca",
                                                   "V",
                                                   "Re",
                                                   "E_b",
                                                   "bending",
                                                   "c0",
                                                   "fluid",  //
                                                   "until.kt",
                                                   "until.classified",  //
                                                   "fidelity.dx",
                                                   "fidelity.box",
                                                   "fidelity.nodes",
                                                   "fidelity.stepper",
                                                   "fidelity.kdt",
                                                   "fidelity.tolerance",
                                                   "fidelity.scheme",
                                                   "fidelity.symmetry",
                                                   "fidelity.precision",  //
                                                   "outputs.history_every",
                                                   "outputs.shapes_every",
                                                   "outputs.checkpoint_every",  //
                                                   "asked.shape",
                                                   "asked.aspect",
                                                   "asked.law",
                                                   "asked.C",
                                                   "asked.Ca",
                                                   "asked.V",
                                                   "asked.Re",
                                                   "asked.E_b",
                                                   "asked.bending",
                                                   "asked.c0",
                                                   "asked.fluid",
                                                   "asked.fidelity",  //
                                                   "final.kt",
                                                   "final.D_xy",
                                                   "final.theta",
                                                   "final.psi",
                                                   "final.volume",
                                                   "final.area",
                                                   "final.iterations",
                                                   "final.error",  //
                                                   "evidence.n_theta",
                                                   "evidence.n_psi",
                                                   "evidence.r",
                                                   "evidence.D_min",
                                                   "evidence.turns",
                                                   "evidence.theta_range",
                                                   "evidence.margin",  //
                                                   "cost.seconds",
                                                   "cost.steps",
                                                   "cost.flow_iterations",
                                                   "cost.peak_memory_mb",  //
                                                   "trust.numerics_version",
                                                   "trust.fluid",
                                                   "trust.bending",
                                                   "trust.volume_drift",
                                                   "trust.area_drift",
                                                   "trust.worst_flow_error",
                                                   "trust.left_out",
                                                   "trust.surface.largest_dihedral",
                                                   "trust.surface.folded_edges",
                                                   "trust.surface.smallest_angle",
                                                   "trust.surface.folded_from",
                                                   "trust.surface.lost_from"};
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
  for (const char* path :
       {"state", "motion", "kt", "final.D_xy", "final.theta", "evidence.margin", "message"})
    columns.push_back(path == std::string("final.theta") ? ResultColumn{"θ/π", path, std::numbers::pi}
                                                         : ResultColumn{short_name(path), path});
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
