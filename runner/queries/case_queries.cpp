#include <algorithm>
#include <iterator>

#include "runner/queries/queries.hpp"
#include "runner/queries/typed_value.hpp"
#include "runner/recording/history.hpp"
#include "runner/store/timestamp.hpp"
#include "runner/study/axis.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kColumns =
    "SELECT c.id, c.state, c.message, c.document, c.kt, c.attempt, c.crashes, r.motion, r.document";
constexpr const char* kTables = " FROM cases c LEFT JOIN results r ON r.case_id = c.id ";

/// After them, where a study is asked for, what concerns the point. CROSS JOIN keeps the order of the tables:
/// along the study, so that a page costs what it holds.
constexpr const char* kOfPoint =
    ", s.position, s.replaces, s.asked,"
    " (SELECT min(position) FROM study_cases f WHERE f.case_id = s.case_id AND f.study_id = s.study_id)"
    " FROM study_cases s CROSS JOIN cases c ON c.id = s.case_id LEFT JOIN results r ON r.case_id = c.id"
    " WHERE s.study_id = ? AND s.position > ? AND c.state = ifnull(nullif(?, ''), c.state)"
    " AND ifnull(r.motion, '') = ifnull(nullif(?, ''), ifnull(r.motion, '')) ORDER BY s.position";
constexpr int kDocument = 3, kPosition = 9, kReplaces = 10, kAsked = 11, kFirst = 12;

bool is_one_of(const std::string& value, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), value) != words.end();
}

bool is_ended(const std::string& state) { return state != "queued" && state != "running"; }

/// What result.json says and the case does not say itself, null before there is anything.
void add_result(ordered_json& shown, const std::string& document) {
  for (const char* key : {"stop", "explanation", "evidence", "final", "cost", "trust"}) shown[key] = nullptr;
  if (document.empty()) return;
  const ordered_json result = ordered_json::parse(document);
  for (const auto& [key, value] : result.items())
    if (!is_one_of(key, {"format", "case", "choices", "message", "motion"})) shown[key] = value;
}

ordered_json case_of(const Statement& row) {
  const std::string state = row.text(1);
  ordered_json parameters = ordered_json::parse(row.text(3));
  const double kt = row.real(4);
  ordered_json shown = {{"id", row.text(0)}, {"state", state}, {"message", row.text(2)}};
  shown["motion"] = row.is_null(7) ? ordered_json() : ordered_json(row.text(7));
  const bool is_complete = is_ended(state) && state != "cancelled";
  shown["progress"] = is_complete ? 1.0 : std::min(1.0, kt / parameters["until"]["kt"].get<double>());
  shown["kt"] = kt;
  shown["parameters"] = std::move(parameters);
  add_result(shown, row.text(8));
  shown["attempt"] = row.integer(5);
  shown["crashes"] = row.integer(6);
  return shown;
}

/// Keys that were asked for at the point and that its case does not have.
ordered_json keys_without_effect(const json& asked, const ordered_json& parameters) {
  ordered_json keys = ordered_json::array();
  for (const auto& [key, value] : asked.items()) {
    if (!parameters.contains(key)) keys.push_back(key);
    if (key != "fidelity" || !value.is_object()) continue;
    for (const auto& [knob, setting] : value.items())
      if (knob != "preset" && !parameters[key].contains(knob)) keys.push_back(key + "." + knob);
  }
  return keys;
}

/// Where the case is not what was asked for because the solver chose.
ordered_json choices_at(json asked, const ordered_json& parameters) {
  drop_keys_without_effect(asked);
  Choices choices = parse_case(asked).choices;
  std::erase_if(choices, [&](const Choice& choice) {  // today's rules are not those of an older case
    return parameters.contains(choice.key) && parameters[choice.key] != ordered_json(choice.chosen);
  });
  return to_json(choices);
}

ordered_json point_of(const Statement& row) {
  ordered_json shown = {{"point", row.integer(kPosition) + 1}};
  const json asked = json::parse(row.text(kAsked));
  shown.update(case_of(row));
  if (row.integer(kFirst) < row.integer(kPosition)) shown["same_as"] = row.integer(kFirst) + 1;
  if (!row.is_null(kReplaces)) shown["replaces"] = row.text(kReplaces);
  shown["asked"] = asked;
  if (ordered_json keys = keys_without_effect(asked, shown["parameters"]); !keys.empty())
    shown["without_effect"] = std::move(keys);
  shown["choices"] = choices_at(asked, shown["parameters"]);
  return shown;
}

/// The value that the filter wants of state or motion, or "".
std::string wanted_word(const CaseFilter& filter, const std::string& key) {
  const auto found =
      std::find_if(filter.begin(), filter.end(), [&](const auto& each) { return each.first == key; });
  return found == filter.end() ? "" : found->second;
}

/// The conditions of a filter on the parameters of one study's points.
class ParameterFilter {
 public:
  ParameterFilter(const CaseFilter& filter, const json& axes) {
    for (const auto& [key, value] : filter)
      if (key != "state" && key != "motion") add(key, value, axes);
  }

  bool lets_pass(const Statement& row) const {
    if (parameters_.empty()) return true;
    const json asked = json::parse(row.text(kAsked));
    const auto is_met = [&](const Parameter& condition) {
      if (condition.is_axis) return condition.value && asked.value(condition.key, json()) == *condition.value;
      if (asked.contains(condition.key) && means(condition.text, asked[condition.key])) return true;
      return means(condition.text, json::parse(row.text(kDocument)).value(condition.key, json()));
    };
    return std::all_of(parameters_.begin(), parameters_.end(), is_met);
  }

 private:
  struct Parameter {
    std::string key, text;
    bool is_axis = false;
    std::optional<json> value;  ///< of the axis; nothing if it has no such value
  };

  void add(const std::string& key, const std::string& text, const json& axes) {
    Parameter& condition = parameters_.emplace_back(Parameter{key, text, false, std::nullopt});
    for (const json& axis : axes) {
      if (axis["parameter"] != key) continue;
      const std::vector<json> values = axis["values"];
      condition.is_axis = true;
      if (const auto place = find_typed(values, text)) condition.value = values[*place];
    }
  }

  std::vector<Parameter> parameters_;
};

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
  Statement row = database.query(std::string(kColumns) + kOfPoint, study_id, wanted.after.value_or(-1),
                                 wanted_word(filter, "state"), wanted_word(filter, "motion"));
  Page page{ordered_json::array(), std::nullopt};
  std::size_t size = 0;
  for (std::int64_t last = 0; row.step();) {
    if (!parameters.lets_pass(row)) continue;
    if (std::ssize(page.items) == wanted.limit || size > kPageBytes) {
      page.next = last;
      break;
    }
    page.items.push_back(point_of(row));
    size += page.items.back().dump(-1, ' ', false, ordered_json::error_handler_t::replace).size();
    last = row.integer(kPosition);
  }
  return page;
}

std::vector<PointMotion> find_points(Database& database, const std::string& study_id) {
  std::vector<PointMotion> points;
  Statement row = database.query(
      "SELECT c.id, c.state, r.motion, s.asked FROM study_cases s JOIN cases c ON c.id = s.case_id"
      " LEFT JOIN results r ON r.case_id = c.id WHERE s.study_id = ? ORDER BY s.position",
      study_id);
  while (row.step()) points.push_back({row.text(0), row.text(1), row.text(2), json::parse(row.text(3))});
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
