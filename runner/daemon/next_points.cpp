#include "runner/daemon/next_points.hpp"

#include <algorithm>

#include "runner/boundary/next_corners.hpp"
#include "runner/boundary/next_values.hpp"
#include "runner/queries/boundary_rows.hpp"
#include "runner/study/study_refinement.hpp"

namespace capstan {
namespace {

using nlohmann::json;

std::vector<json> points_of_boundary(Database& database, const std::string& study_id,
                                     const StudyBoundary& boundary) {
  std::vector<json> next;
  for (const auto& [row, points] : boundary_rows(database, study_id, boundary))
    for (const double value : next_values(boundary.search, points)) {
      json& point = next.emplace_back(json{{boundary.along, value}});
      for (std::size_t i = 0; i < row.size(); ++i) point[boundary.rows_of[i]] = row[i];
    }
  return next;
}

/// The values of an axis in the study's document, ascending.
std::vector<double> values_of(const std::string& parameter, const json& document) {
  Issues issues;
  std::vector<double> values;
  if (const auto axis = read_axis(parameter, document["axes"][parameter], "", issues))
    for (std::size_t i = 0; static_cast<double>(i) < axis->size(); ++i) values.push_back(axis->value(i));
  std::ranges::sort(values);
  return values;
}

/// The values of the parameters that are axes and not refined.
json fixed_values(const json& asked, const json& document, const StudyRefinement& refinement) {
  json fixed = json::object();
  for (const auto& [parameter, values] : document["axes"].items())
    if (std::ranges::find(refinement.axes, parameter) == refinement.axes.end())
      fixed[parameter] = asked[parameter];
  return fixed;
}

std::vector<json> points_of_grid(Database& database, const std::string& study_id, const json& document,
                                 const StudyRefinement& refinement) {
  const auto& [x, y] = refinement.axes;
  std::map<json, RefinedGrid> grids;  // by the values of the other axes
  for (const auto& [asked, point] : search_points(database, study_id)) {
    const Corner corner = {asked[x], asked[y]};
    grids[fixed_values(asked, document, refinement)].points.emplace(corner, point);
  }
  std::vector<json> next;
  for (auto& [fixed, grid] : grids) {
    grid.values = {values_of(x, document), values_of(y, document)};
    grid.sides = refinement.sides;
    for (const Corner& corner : next_corners(grid)) {
      json& point = next.emplace_back(fixed);
      point[x] = corner[0];
      point[y] = corner[1];
    }
  }
  return next;
}

}  // namespace

std::vector<json> next_points(Database& database, const std::string& study_id, const json& document) {
  if (const auto boundary = boundary_of(document)) return points_of_boundary(database, study_id, *boundary);
  if (const auto refinement = refinement_of(document))
    return points_of_grid(database, study_id, document, *refinement);
  return {};
}

}  // namespace capstan
