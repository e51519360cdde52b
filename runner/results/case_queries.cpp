#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "runner/results/history.hpp"
#include "runner/results/queries.hpp"
#include "runner/results/timestamp.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

constexpr const char* kColumns =
    "SELECT c.id, c.state, c.message, c.document, c.kt, c.attempt, c.crashes, r.motion, r.document";
constexpr const char* kTables = " FROM cases c LEFT JOIN results r ON r.case_id = c.id ";
constexpr int kPosition = 9, kReplaces = 10;  // after the columns, where a study is asked for

bool is_ended(const std::string& state) { return state != "queued" && state != "running"; }

/// The parts of result.json that a case shows, null before there are any.
void add_result(ordered_json& shown, const std::string& document) {
  const ordered_json result = document.empty() ? ordered_json::object() : ordered_json::parse(document);
  for (const char* key : {"evidence", "stop", "final", "cost", "trust"})
    shown[key] = result.contains(key) ? result[key] : ordered_json();
}

ordered_json case_of(const Statement& row) {
  const std::string state = row.text(1);
  ordered_json parameters = ordered_json::parse(row.text(3));
  const double kt = row.real(4);
  ordered_json shown = {{"id", row.text(0)}, {"state", state}, {"message", row.text(2)}};
  shown["motion"] = row.is_null(7) ? ordered_json() : ordered_json(row.text(7));
  shown["progress"] = is_ended(state) ? 1.0 : std::min(1.0, kt / parameters["until"]["kt"].get<double>());
  shown["kt"] = kt;
  shown["parameters"] = std::move(parameters);
  add_result(shown, row.text(8));
  shown["attempt"] = row.integer(5);
  shown["crashes"] = row.integer(6);
  return shown;
}

std::optional<double> number_in(const std::string& text) {
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

/// SQL for one condition; its values are the next two parameters.
std::string condition_on(const std::string& key, const std::string& value) {
  if (key == "state") return " AND c.state IN (?, ?)";
  if (key == "motion") return " AND r.motion IN (?, ?)";
  const std::string parameter =
      "json_extract(c.document, '$." + key + "')";  // key is one of scalar_parameters()
  return number_in(value) ? " AND " + parameter + " BETWEEN ? AND ?" : " AND " + parameter + " IN (?, ?)";
}

/// Numbers are equal when they agree to nine digits: nobody types more.
void bind_condition(Statement& statement, int index, const std::string& value) {
  if (const auto number = number_in(value)) {
    const double margin = 1e-9 * std::abs(*number);
    statement.bind(index, *number - margin);
    statement.bind(index + 1, *number + margin);
  } else {
    statement.bind(index, value);
    statement.bind(index + 1, value);
  }
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
  // CROSS JOIN keeps the order of the tables: along the study, so that a page costs what it holds.
  std::string sql = std::string(kColumns) +
                    ", s.position, s.replaces FROM study_cases s CROSS JOIN cases c ON c.id = s.case_id"
                    " LEFT JOIN results r ON r.case_id = c.id WHERE s.study_id = ? AND s.position > ?";
  for (const auto& [key, value] : filter) sql += condition_on(key, value);
  Statement row = database.query(sql + " ORDER BY s.position LIMIT " + std::to_string(wanted.limit + 1),
                                 study_id, wanted.after.value_or(-1));
  int index = 3;
  for (const auto& [key, value] : filter) {
    bind_condition(row, index, value);
    index += 2;
  }
  Page page{ordered_json::array(), std::nullopt};
  for (std::int64_t last = 0; row.step(); last = row.integer(kPosition)) {
    if (std::ssize(page.items) == wanted.limit) {
      page.next = last;
      break;
    }
    page.items.push_back(case_of(row));
    if (!row.is_null(kReplaces)) page.items.back()["replaces"] = row.text(kReplaces);
  }
  return page;
}

ordered_json find_points(Database& database, const std::string& study_id) {
  ordered_json points = ordered_json::array();
  Statement row = database.query(
      "SELECT c.id, c.state, r.motion, c.document FROM study_cases s JOIN cases c ON c.id = s.case_id"
      " LEFT JOIN results r ON r.case_id = c.id WHERE s.study_id = ? ORDER BY s.position",
      study_id);
  while (row.step())
    points.push_back({{"id", row.text(0)},
                      {"state", row.text(1)},
                      {"motion", row.is_null(2) ? ordered_json() : ordered_json(row.text(2))},
                      {"parameters", ordered_json::parse(row.text(3))}});
  return points;
}

std::optional<ordered_json> find_case(Database& database, const std::string& case_id) {
  Statement row = database.query(std::string(kColumns) + kTables + "WHERE c.id = ?", case_id);
  if (!row.step()) return std::nullopt;
  ordered_json found = case_of(row);
  found["attempts"] = attempts_of(database, case_id);
  found["studies"] = studies_of(database, case_id);
  return found;
}

std::optional<ordered_json> find_history(Database& database, const std::string& case_id) {
  if (!database.query("SELECT 1 FROM cases WHERE id = ?", case_id).step()) return std::nullopt;
  ordered_json columns;
  for (const char* name : kHistoryColumns) columns[name] = ordered_json::array();
  Statement row = database.query(
      "SELECT kt, D_xy, theta, psi, volume, area FROM histories WHERE case_id = ? ORDER BY record", case_id);
  while (row.step())
    for (std::size_t i = 0; i < kHistoryColumns.size(); ++i) {
      const int column = static_cast<int>(i);
      columns[kHistoryColumns[i]].push_back(row.is_null(column) ? ordered_json()
                                                                : ordered_json(row.real(column)));
    }
  return columns;
}

}  // namespace capstan
