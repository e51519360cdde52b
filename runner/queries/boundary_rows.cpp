#include "runner/queries/boundary_rows.hpp"

#include <cmath>

#include "runner/queue/case_state.hpp"

namespace capstan {
namespace {

using nlohmann::json;

double real_or_nan(const Statement& row, int column) {
  return row.is_null(column) ? std::nan("") : row.real(column);
}

/// A cancelled case has not ended: it may be queued again.
bool has_answer_or_failed(const std::string& state) {
  const auto parsed = parse_word<CaseState>(state);
  return parsed && has_ended(*parsed) && parsed != CaseState::cancelled;
}

RowPoint point_of(const Statement& row) {
  RowPoint point;
  point.has_ended = has_answer_or_failed(row.text(1));
  const auto motion = parse_word<Motion>(row.text(2));
  point.r = real_or_nan(row, 4);
  point.D_min = real_or_nan(row, 5);
  point.error = real_or_nan(row, 6);
  point.is_confirmed = row.integer(3) != 0;
  const bool has_evidence = !std::isnan(point.r) && !std::isnan(point.D_min);
  if (point.has_ended && motion != Motion::undecided && has_evidence) point.motion = motion;
  return point;
}

}  // namespace

std::vector<SearchPoint> search_points(Database& database, const std::string& study_id) {
  std::vector<SearchPoint> points;
  Statement row = database.query(
      "SELECT p.asked, c.state, r.motion, r.document ->> '$.confirmed', r.document ->> '$.evidence.r',"
      " r.document ->> '$.evidence.D_min', r.document ->> '$.error.Q'"
      " FROM study_cases p JOIN cases c ON c.id = p.case_id LEFT JOIN results r ON r.case_id = c.id"
      " WHERE p.study_id = ? ORDER BY p.position",
      study_id);
  while (row.step()) points.push_back({json::parse(row.text(0)), point_of(row)});
  return points;
}

BoundaryRows boundary_rows(Database& database, const std::string& study_id, const StudyBoundary& boundary) {
  BoundaryRows rows;
  for (auto& [asked, point] : search_points(database, study_id)) {
    json key = json::array();
    for (const std::string& parameter : boundary.rows_of) key.push_back(asked[parameter]);
    point.value = asked[boundary.along];
    rows[key].push_back(point);
  }
  return rows;
}

std::optional<StudyBoundary> boundary_of_study(Database& database, const std::string& study_id) {
  Statement row = database.query(
      "SELECT document FROM studies WHERE id = ? AND document -> '$.boundary' IS NOT NULL", study_id);
  if (!row.step()) return std::nullopt;
  return boundary_of(json::parse(row.text(0)));
}

}  // namespace capstan
