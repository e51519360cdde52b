#include "runner/daemon/points.hpp"

namespace capstan {

void add_point(Database& database, const Point& point) {
  database.execute(
      "INSERT INTO study_cases (study_id, position, case_id, replaces, asked)"
      " VALUES (?, ?, ?, nullif(?, ''), nullif(?, ''))",
      point.study_id, point.position, point.case_id, point.replaces, point.asked);
}

void remove_point(Database& database, const Point& point) {
  database.execute("DELETE FROM study_cases WHERE study_id = ? AND position = ?", point.study_id,
                   point.position);
}

std::vector<Point> points_of_case(Database& database, const std::string& case_id,
                                  const std::string& study_id) {
  std::vector<Point> points;
  Statement row = database.query(
      "SELECT study_id, position, case_id, asked, replaces FROM study_cases"
      " WHERE case_id = ?1 AND (study_id = ?2 OR ?2 = '')",
      case_id, study_id);
  while (row.step()) points.push_back({row.text(0), row.integer(1), row.text(2), row.text(3), row.text(4)});
  return points;
}

nlohmann::json listed(const std::vector<Axis>& axes) {
  nlohmann::json list = nlohmann::json::array();
  for (const Axis& axis : axes) {
    nlohmann::json values = nlohmann::json::array();
    for (std::size_t i = 0; i < static_cast<std::size_t>(axis.size()); ++i) values.push_back(axis.value(i));
    list.push_back({{"parameter", axis.parameter()}, {"values", values}});
  }
  return list;
}

}  // namespace capstan
