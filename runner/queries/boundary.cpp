#include "runner/queries/boundary.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "runner/boundary/location.hpp"
#include "runner/boundary/next_values.hpp"
#include "runner/queries/boundary_rows.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& number) {
  return number ? ordered_json(*number) : ordered_json();
}

ordered_json pair_or_nulls(const std::optional<double>& first, const std::optional<double>& second) {
  return ordered_json::array({or_null(first), or_null(second)});
}

ordered_json crossing_json(const std::vector<RowPoint>& points, const Crossing& crossing, double tolerance) {
  const Location at = locate(points, crossing);
  constexpr double kRounding = 1e-9;
  return {{"from", to_string(crossing.from)},
          {"to", to_string(crossing.to)},
          {"value", or_null(at.value)},
          {"bracket", pair_or_nulls(at.below, at.above)},
          {"low", or_null(at.low)},
          {"high", or_null(at.high)},
          {"band", pair_or_nulls(at.band_begin, at.band_end)},
          {"found", at.value && *at.above <= *at.below * (1 + tolerance + kRounding)},
          {"confirmed", pair_or_nulls(at.confirmed_below, at.confirmed_above)}};
}

bool is_waiting(const RowPoint& point) { return !point.has_ended; }

ordered_json motion_or_null(const std::vector<RowPoint>& points, std::size_t index) {
  return points.empty() ? ordered_json() : ordered_json(to_string(*points[index].motion));
}

ordered_json row_json(const StudyBoundary& boundary, const json& key, const std::vector<RowPoint>& row) {
  const std::vector<RowPoint> points = labelled(row);
  ordered_json shown = {{"at", ordered_json::object()}};
  for (std::size_t i = 0; i < key.size(); ++i) shown["at"][boundary.rows_of[i]] = key[i];
  shown["searching"] = std::ranges::any_of(row, is_waiting);
  shown["first"] = motion_or_null(points, 0);
  shown["last"] = motion_or_null(points, points.size() - 1);
  shown["crossings"] = ordered_json::array();
  for (const Crossing& crossing : find_crossings(points))
    shown["crossings"].push_back(crossing_json(points, crossing, boundary.search.tolerance));
  return shown;
}

/// Joins the crossings of neighbouring rows to curves: the first one out of a motion with the first one of
/// the next row, the second with the second. A row without such a crossing ends the curve.
class Curves {
 public:
  /// \param over  the parameter of the rows along which neighbours are joined; "" if the rows have none
  explicit Curves(std::string over) : over_(std::move(over)) {}

  void add_row(const ordered_json& row) {
    ordered_json at = row["at"];
    const ordered_json place = over_.empty() ? ordered_json() : at[over_];
    at.erase(over_);
    if (at != at_) open_.clear();
    at_ = at;
    std::map<Kind, std::size_t> still_open;
    std::map<std::string, int> seen;
    for (const ordered_json& crossing : row["crossings"]) {
      const std::string motion = motion_of(crossing);
      const Kind kind = {motion, seen[motion]++};
      const auto known = open_.find(kind);
      const std::size_t curve = known == open_.end() ? begin() : known->second;
      add_point(curves_[curve], crossing, place);
      still_open[kind] = curve;
    }
    open_ = still_open;
  }

  const ordered_json& json() const { return curves_; }

 private:
  using Kind = std::pair<std::string, int>;

  /// The motion below the crossing. Where that is cut off by the range, the one above.
  static std::string motion_of(const ordered_json& crossing) {
    const bool is_cut_off = crossing["from"] == to_string(Motion::transition);
    return is_cut_off ? "to " + crossing["to"].get<std::string>() : crossing["from"].get<std::string>();
  }

  std::size_t begin() {
    curves_.push_back({{"from", nullptr},
                       {"to", nullptr},
                       {"over", over_.empty() ? ordered_json() : ordered_json(over_)},
                       {"at", at_},
                       {"points", ordered_json::array()}});
    return curves_.size() - 1;
  }

  static void add_point(ordered_json& curve, const ordered_json& crossing, const ordered_json& place) {
    for (const char* end : {"from", "to"})
      if (curve[end].is_null() || curve[end] == to_string(Motion::transition)) curve[end] = crossing[end];
    curve["points"].push_back({{"over", place},
                               {"value", crossing["value"]},
                               {"low", crossing["low"]},
                               {"high", crossing["high"]},
                               {"band", crossing["band"]}});
  }

  std::string over_;
  ordered_json at_;
  std::map<Kind, std::size_t> open_;  ///< index of the curve that goes on in the next row
  ordered_json curves_ = ordered_json::array();
};

/// The last parameter that varies from row to row; the first one, if there is a single row.
std::string joined_over(const StudyBoundary& boundary, const BoundaryRows& rows) {
  for (std::size_t i = boundary.rows_of.size(); i-- > 1;)
    if (std::ranges::any_of(rows, [&](const auto& row) { return row.first[i] != rows.begin()->first[i]; }))
      return boundary.rows_of[i];
  return boundary.rows_of.empty() ? "" : boundary.rows_of[0];
}

int expected_points(const StudyBoundary& boundary, const BoundaryRows& rows) {
  int number = 0;
  for (const auto& [key, points] : rows) number += expected_values(boundary.search, points);
  return number;
}

ordered_json count_points(const StudyBoundary& boundary, const BoundaryRows& rows) {
  std::ptrdiff_t asked = 0, waiting = 0;
  for (const auto& [key, points] : rows) {
    asked += std::ssize(points);
    waiting += std::ranges::count_if(points, is_waiting);
  }
  return {{"asked", asked}, {"ended", asked - waiting}, {"expected", expected_points(boundary, rows)}};
}

bool is_cancelled(Database& database, const std::string& study_id) {
  return database.query("SELECT 1 FROM studies WHERE id = ? AND cancelled_at IS NOT NULL", study_id).step();
}

}  // namespace

std::optional<ordered_json> find_boundary(Database& database, const std::string& study_id) {
  const auto boundary = boundary_of_study(database, study_id);
  if (!boundary) return std::nullopt;
  const BoundaryRows rows = boundary_rows(database, study_id, *boundary);
  ordered_json found = {{"study", study_id},
                        {"along", boundary->along},
                        {"for", boundary->rows_of},
                        {"between", {boundary->search.from, boundary->search.to}},
                        {"tolerance", boundary->search.tolerance},
                        {"explored", boundary->explored_gap()}};
  found["points"] = count_points(*boundary, rows);
  found["searching"] =
      found["points"]["ended"] != found["points"]["asked"] && !is_cancelled(database, study_id);
  found["rows"] = ordered_json::array();
  Curves curves(joined_over(*boundary, rows));
  for (const auto& [key, points] : rows) {
    found["rows"].push_back(row_json(*boundary, key, points));
    curves.add_row(found["rows"].back());
  }
  found["curves"] = curves.json();
  return found;
}

int expected_points(Database& database, const std::string& study_id) {
  const auto boundary = boundary_of_study(database, study_id);
  return boundary ? expected_points(*boundary, boundary_rows(database, study_id, *boundary)) : 0;
}

}  // namespace capstan
