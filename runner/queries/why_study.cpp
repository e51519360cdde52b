#include <algorithm>
#include <cctype>
#include <map>

#include "runner/queries/queries.hpp"
#include "runner/queries/why.hpp"
#include "runner/store/timestamp.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The message with # for each run of digits: messages that differ in numbers alone are one reason.
std::string without_numbers(const std::string& message) {
  std::string text;
  for (const char c : message) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!is_digit || text.empty() || text.back() != '#') text += is_digit ? '#' : c;
  }
  return text;
}

/// Number of cases for each reason, in the order in which the reasons were added.
class Reasons {
 public:
  void add(std::int64_t cases, const std::string& reason) {
    if (cases > 0) list_.push_back({{"cases", cases}, {"reason", reason}});
  }

  /// \param example  a case with this message
  void add_message(const std::string& state, const std::string& message, const std::string& example) {
    const auto [kind, is_new] = kinds_.try_emplace(state + without_numbers(message), list_.size());
    if (is_new) {
      const std::string text = message.starts_with(state) ? message : state + ": " + message;
      list_.push_back({{"cases", 0}, {"reason", text + " (" + example + ")"}});
    }
    ordered_json& cases = list_[kind->second]["cases"];
    cases = cases.get<std::int64_t>() + 1;
  }

  ordered_json list() const { return list_; }

 private:
  ordered_json list_ = ordered_json::array();
  std::map<std::string, std::size_t> kinds_;  ///< index in the list, by state and message without numbers
};

std::string why_it_waits(const ordered_json& study, const RunPlaces& places) {
  if (study["cancelled"]) return "queued for another study; this one is cancelled";
  if (study["paused"]) return "queued; the study is paused: capstan resume " + study["id"].get<std::string>();
  if (!places.obstacle.empty()) return "queued; " + places.obstacle;
  return "queued until there is room (" + std::to_string(places.slots) + " " + places.slot_name +
         ") and it is this study's turn";
}

/// Adds the cases in this state that have a message. Returns their number.
std::int64_t add_messages(Database& database, const std::string& study_id, const char* state,
                          Reasons& reasons) {
  std::int64_t cases = 0;
  Statement row = database.query(
      "SELECT DISTINCT c.id, c.message FROM study_cases w JOIN cases c ON c.id = w.case_id"
      " WHERE w.study_id = ? AND c.state = ? AND c.message <> ''",
      study_id, state);
  for (; row.step(); ++cases) reasons.add_message(state, first_line(row.text(1)), "case " + row.text(0));
  return cases;
}

/// Adds the undecided cases, by what they lack. Returns their number.
std::int64_t add_undecided(Database& database, const std::string& study_id, Reasons& reasons) {
  std::int64_t cases = 0;
  Statement row = database.query(
      "SELECT DISTINCT case_id, r.document ->> '$.explanation' FROM study_cases JOIN results r USING "
      "(case_id)"
      " WHERE study_id = ? AND motion = 'undecided'",
      study_id);
  for (; row.step(); ++cases) reasons.add_message("undecided", row.text(1), "case " + row.text(0));
  return cases;
}

/// Adds the running cases, by where they are.
void add_running(Database& database, const std::string& study_id, const RunPlaces& places, Reasons& reasons) {
  std::map<std::string, std::int64_t> cases_at;
  Statement row = database.query(
      "SELECT DISTINCT c.id, a.handle FROM study_cases w JOIN cases c ON c.id = w.case_id"
      " JOIN attempts a ON a.case_id = c.id AND a.attempt = c.attempt WHERE w.study_id = ? AND c.state ="
      " 'running'",
      study_id);
  while (row.step()) ++cases_at[places.place_of(row.text(1)).kind];
  for (const auto& [kind, cases] : cases_at) reasons.add(cases, kind);
}

}  // namespace

std::optional<ordered_json> why_study(Database& database, const std::string& study_id,
                                      const RunPlaces& places) {
  const auto study = find_study(database, study_id);
  if (!study) return std::nullopt;
  const auto count = [&](const char* state) { return (*study)["cases"][state].get<std::int64_t>(); };
  Reasons reasons;
  const std::int64_t to_be_tried_again = add_messages(database, study_id, "queued", reasons);
  reasons.add(count("queued") - to_be_tried_again, why_it_waits(*study, places));
  add_running(database, study_id, places, reasons);
  for (const char* state : {"failed", "diverged", "cancelled"})
    add_messages(database, study_id, state, reasons);
  const std::int64_t undecided = add_undecided(database, study_id, reasons);
  reasons.add(count("done") - undecided, "done, with an answer");
  return ordered_json{{"id", study_id}, {"state", (*study)["state"]}, {"reasons", reasons.list()}};
}

}  // namespace capstan
