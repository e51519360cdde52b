#include <iterator>

#include "runner/queries/case_filter.hpp"
#include "runner/queries/case_json.hpp"
#include "runner/queries/queries.hpp"
#include "runner/store/timestamp.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// CROSS JOIN makes SQLite read the tables in this order: it goes through the points of the study and stops
/// at the end of the page.
constexpr const char* kFilteredPoints =
    " FROM study_cases s CROSS JOIN cases c ON c.id = s.case_id LEFT JOIN results r ON r.case_id = c.id"
    " WHERE s.study_id = ? AND s.position > ? AND c.state = ifnull(nullif(?, ''), c.state)"
    " AND ifnull(r.motion, '') = ifnull(nullif(?, ''), ifnull(r.motion, '')) ORDER BY s.position";

json axes_of(Database& database, const std::string& study_id) {
  Statement row = database.query("SELECT axes FROM studies WHERE id = ?", study_id);
  return row.step() ? json::parse(row.text(0)) : json::array();
}

ordered_json attempts_of(Database& database, const std::string& case_id) {
  ordered_json attempts = ordered_json::array();
  Statement row = database.query(
      "SELECT attempt, started_at, ended_at, ending, reason FROM attempts WHERE case_id = ? ORDER BY attempt",
      case_id);
  while (row.step())
    attempts.push_back(
        {{"attempt", row.integer(0)},
         {"started_at", timestamp(row.integer(1))},
         {"ended_at", row.is_null(2) ? ordered_json() : ordered_json(timestamp(row.integer(2)))},
         {"ending", row.is_null(3) ? ordered_json() : ordered_json(row.text(3))},
         {"reason", row.text(4)}});
  return attempts;
}

ordered_json studies_of(Database& database, const std::string& case_id) {
  ordered_json ids = ordered_json::array();
  Statement row = database.query("SELECT DISTINCT study_id FROM study_cases WHERE case_id = ?", case_id);
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

}  // namespace

Page find_cases(Database& database, const std::string& study_id, const CaseFilter& filter,
                const PageRequest& wanted) {
  const ParameterFilter parameters(filter, axes_of(database, study_id));
  Statement row =
      database.query(std::string(kCaseColumns) + kPointColumns + kFilteredPoints, study_id,
                     wanted.after.value_or(-1), wanted_word(filter, "state"), wanted_word(filter, "motion"));
  Page page{ordered_json::array(), std::nullopt};
  std::size_t size = 0;
  for (std::int64_t last = 0; row.step();) {
    if (!parameters.matches(row.text(kAskedColumn), row.text(kDocumentColumn))) continue;
    if (std::ssize(page.items) == wanted.limit || size > kPageBytes) {
      page.next = last;
      break;
    }
    page.items.push_back(point_json(row));
    size += page.items.back().dump(-1, ' ', false, ordered_json::error_handler_t::replace).size();
    last = row.integer(kPositionColumn);
  }
  return page;
}

std::vector<PointMotion> find_points(Database& database, const std::string& study_id) {
  std::vector<PointMotion> points;
  Statement row = database.query(
      "SELECT c.id, c.state, r.motion, s.asked, r.document ->> '$.confirmed' FROM study_cases s JOIN cases c "
      "ON c.id = s.case_id"
      " LEFT JOIN results r ON r.case_id = c.id WHERE s.study_id = ? ORDER BY s.position",
      study_id);
  while (row.step())
    points.push_back({row.text(0), row.text(1), row.text(2), json::parse(row.text(3)), row.integer(4) != 0});
  return points;
}

std::optional<ordered_json> find_case(Database& database, const std::string& case_id) {
  Statement row = database.query(
      std::string(kCaseColumns) + " FROM cases c LEFT JOIN results r ON r.case_id = c.id WHERE c.id = ?",
      case_id);
  if (!row.step()) return std::nullopt;
  ordered_json found = case_json(row);
  found["attempts"] = attempts_of(database, case_id);
  found["studies"] = studies_of(database, case_id);
  return found;
}

}  // namespace capstan
