#include "runner/daemon/extend_search.hpp"

#include <optional>
#include <set>

#include "runner/daemon/case_rows.hpp"
#include "runner/daemon/next_points.hpp"
#include "runner/daemon/points.hpp"
#include "runner/study/study_base.hpp"

namespace capstan {
namespace {

using nlohmann::json;

/// A condition on a study `s`.
const std::string kIsExtended =
    "(s.document -> '$.boundary' IS NOT NULL OR s.document -> '$.refine' IS NOT NULL)";

struct ExtendedStudy {
  std::string id;
  json document;
};

/// Nothing if the study is not extended, or is cancelled.
std::optional<ExtendedStudy> find_extended(Database& database, const std::string& study_id) {
  Statement row = database.query(
      "SELECT document FROM studies s WHERE id = ? AND cancelled_at IS NULL AND " + kIsExtended, study_id);
  if (!row.step()) return std::nullopt;
  return ExtendedStudy{study_id, json::parse(row.text(0))};
}

std::int64_t next_position(Database& database, const std::string& study_id) {
  Statement row =
      database.query("SELECT ifnull(max(position) + 1, 0) FROM study_cases WHERE study_id = ?", study_id);
  row.step();
  return row.integer(0);
}

/// False if this version refuses the case: then the study is not extended there.
bool add_point_at(Database& database, const ExtendedStudy& study, const json& point) {
  json asked = base_of(study.document);
  asked.update(point);
  const ParsedCase parsed = parse_stored_case(asked);
  if (!parsed.value) return false;
  for (const char* key : {"until", "outputs"}) asked.erase(key);
  add_point(database, {study.id, next_position(database, study.id), add_case(database, *parsed.value),
                       asked.dump(), ""});
  return true;
}

/// The column `axes` of the study lists the values of all its points.
void list_values(Database& database, const ExtendedStudy& study, const std::vector<json>& added) {
  Statement row = database.query("SELECT axes FROM studies WHERE id = ?", study.id);
  row.step();
  json axes = json::parse(row.text(0));
  for (json& axis : axes) {
    std::set<json> values(axis["values"].begin(), axis["values"].end());
    for (const json& point : added) values.insert(point[axis["parameter"].get<std::string>()]);
    axis["values"] = values;
  }
  database.execute("UPDATE studies SET axes = ? WHERE id = ?", axes.dump(), study.id);
}

/// Adds the next points. False if there are none.
bool add_next_points(Database& database, const ExtendedStudy& study) {
  std::vector<json> added;
  for (const json& point : next_points(database, study.id, study.document))
    if (add_point_at(database, study, point)) added.push_back(point);
  if (!added.empty()) list_values(database, study, added);
  return !added.empty();
}

void extend_all(Database& database, Statement rows) {
  std::vector<std::string> ids;
  while (rows.step()) ids.push_back(rows.text(0));
  for (const std::string& id : ids) extend_search(database, id);
}

}  // namespace

/// New points may be cases that another study has computed: then the next ones follow at once.
void extend_search(Database& database, const std::string& study_id) {
  Transaction transaction(database);
  if (const auto study = find_extended(database, study_id))
    while (add_next_points(database, *study)) {
    }
  transaction.commit();
}

void extend_searches_with(Database& database, const std::string& case_id) {
  extend_all(database,
             database.query("SELECT DISTINCT s.id FROM study_cases p JOIN studies s ON s.id = p.study_id"
                            " WHERE p.case_id = ? AND " +
                                kIsExtended,
                            case_id));
}

void extend_all_searches(Database& database) {
  extend_all(database, database.query("SELECT s.id FROM studies s WHERE " + kIsExtended));
}

}  // namespace capstan
