#pragma once
// The recorded points of studies that choose further points by them.
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/boundary/row.hpp"
#include "runner/store/database.hpp"
#include "runner/study/study_boundary.hpp"

namespace capstan {

struct SearchPoint {
  nlohmann::json asked;  ///< the values asked for
  RowPoint point;        ///< its `value` is not set
};
/// All points of a study.
std::vector<SearchPoint> search_points(Database& database, const std::string& study_id);

/// The points of each row. The key are the values of the row's parameters, in the order of
/// StudyBoundary::rows_of: [4].
using BoundaryRows = std::map<nlohmann::json, std::vector<RowPoint>>;
BoundaryRows boundary_rows(Database& database, const std::string& study_id, const StudyBoundary& boundary);

/// What the study seeks; nothing if it seeks no boundary, or if there is no such study.
std::optional<StudyBoundary> boundary_of_study(Database& database, const std::string& study_id);

}  // namespace capstan
