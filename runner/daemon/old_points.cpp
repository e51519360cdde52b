#include <optional>

#include "runner/daemon/points.hpp"
#include "runner/study/study.hpp"

namespace capstan {
namespace {

using nlohmann::json;

std::vector<std::string> studies_without_points(Database& database) {
  std::vector<std::string> ids;
  Statement row = database.query("SELECT DISTINCT study_id FROM study_cases WHERE asked IS NULL");
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

std::vector<Point> points_of_study(Database& database, const std::string& study_id) {
  std::vector<Point> points;
  Statement row = database.query(
      "SELECT position, case_id, replaces FROM study_cases WHERE study_id = ? ORDER BY position", study_id);
  while (row.step()) points.push_back({study_id, row.integer(0), row.text(1), "", row.text(2)});
  return points;
}

json column_of_study(Database& database, const char* column, const std::string& study_id) {
  Statement row = database.query(std::string("SELECT ") + column + " FROM studies WHERE id = ?", study_id);
  row.step();
  return json::parse(row.text(0));
}

/// Parses a stored document by today's rules. Nothing if it is invalid, or if it gives another number of
/// cases than are stored.
std::optional<Study> parse_stored_study(const json& document, std::size_t cases) {
  ParsedStudy parsed = parse_study(document);
  return parsed.value && parsed.value->cases.size() == cases ? std::move(parsed.value) : std::nullopt;
}

/// The points of the study. Each takes the case id of the stored row for its case.
/// \param stored  one row for each case of the study
std::vector<Point> points_of(const Study& study, const std::vector<Point>& stored) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    Point& point = points.emplace_back(stored[study.points[i]]);
    point.position = static_cast<std::int64_t>(i);
    point.asked = study.asked_at(i).dump();
  }
  return points;
}

/// Reconstructs the values asked for at a point: those of the base and, for each axis, the value of the case.
json asked_by_case(Database& database, const Point& point, const json& base, const json& axes) {
  Statement row = database.query("SELECT document FROM cases WHERE id = ?", point.case_id);
  row.step();
  const json document = json::parse(row.text(0));
  json asked = base;
  for (const char* key : {"until", "outputs"}) asked.erase(key);
  for (const json& axis : axes) {
    const std::string parameter = axis["parameter"];
    if (document.contains(parameter)) asked[parameter] = document[parameter];
  }
  return asked;
}

void derive(Database& database, const std::string& study_id) {
  const std::vector<Point> stored = points_of_study(database, study_id);
  const json document = column_of_study(database, "document", study_id);
  std::vector<Point> points = stored;
  if (const auto study = parse_stored_study(document, stored.size())) {
    points = points_of(*study, stored);
    database.execute("UPDATE studies SET axes = ?, notes = ? WHERE id = ?", listed(study->axes).dump(),
                     json(study->notes).dump(), study_id);
  } else {
    const json axes = column_of_study(database, "axes", study_id);
    for (Point& point : points) point.asked = asked_by_case(database, point, document["base"], axes).dump();
  }
  for (const Point& point : stored) remove_point(database, point);
  for (const Point& point : points) add_point(database, point);
}

}  // namespace

void derive_old_points(Database& database) {
  for (const std::string& study_id : studies_without_points(database)) {
    Transaction transaction(database);
    derive(database, study_id);
    transaction.commit();
  }
}

}  // namespace capstan
