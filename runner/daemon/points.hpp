#pragma once
// Points of studies as rows of the database: the values asked for and the case that they resolve to.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/store/database.hpp"
#include "runner/study/axis.hpp"

namespace capstan {

struct Point {
  std::string study_id;
  std::int64_t position = 0;  ///< from 0, in the order of the study
  std::string case_id;
  std::string asked;     ///< JSON object of the values asked for; "" until derived for an older study
  std::string replaces;  ///< id of the case that the point had before, or ""
};

void add_point(Database& database, const Point& point);
void remove_point(Database& database, const Point& point);

/// \param study_id  the study whose points are returned; "": all studies
std::vector<Point> points_of_case(Database& database, const std::string& case_id,
                                  const std::string& study_id);

/// The axes as JSON, as in the column `axes` of a study: [{"parameter": .., "values": [..]}, ..].
nlohmann::json listed(const std::vector<Axis>& axes);

/// Adds the points of studies that a version before format 5 stored with one row a case and without the
/// values asked for. They are derived from the study's document; if it is invalid today, from its cases.
void derive_old_points(Database& database);

}  // namespace capstan
