#pragma once
// The points of the studies in the database: what each asks for, and the case that it resolves to.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/store/database.hpp"
#include "runner/study/axis.hpp"

namespace capstan {

struct Point {
  std::string study_id;
  std::int64_t position = 0;
  std::string case_id;
  std::string asked;     ///< JSON; "" where it has still to be derived
  std::string replaces;  ///< the case that stood here before, or ""
};

void add_point(Database& database, const Point& point);
void remove_point(Database& database, const Point& point);

/// \param study_id  "" for those of all studies
std::vector<Point> points_of_case(Database& database, const std::string& case_id,
                                  const std::string& study_id);

/// [{"parameter": .., "values": [..]}, ..] as the studies keep their axes.
nlohmann::json listed(const std::vector<Axis>& axes);

/// The studies of an earlier program have each case once and not what was asked for: gives them all their
/// points. Where the study's document does not tell them any more, a point asks for what its case has.
void derive_old_points(Database& database);

}  // namespace capstan
