#include "runner/queries/why.hpp"

#include "runner/store/timestamp.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

std::int64_t number(Statement row) {
  row.step();
  return row.integer(0);
}

/// Adds one reason for each study that contains the case.
void add_reason_of_study(Database& database, const Statement& study, const RunPlaces& places,
                         ordered_json& reasons) {
  const std::string id = "study " + study.text(0);
  if (study.integer(1) != 0) return reasons.push_back(id + " is cancelled");
  if (study.integer(2) != 0) return reasons.push_back(id + " is paused: capstan resume " + study.text(0));
  const auto ahead = number(
      database.query("SELECT count(DISTINCT case_id) FROM waiting WHERE study_number = ? AND position < ?",
                     study.integer(3), study.integer(4)));
  const auto others = number(database.query(
      "SELECT count(*) FROM schedule WHERE waiting > 0 AND is_paused = 0 AND number <> ?1 AND priority >="
      " (SELECT priority FROM schedule WHERE number = ?1)",
      study.integer(3)));
  const auto running = number(database.query("SELECT count(*) FROM cases WHERE state = 'running'"));
  reasons.push_back("in " + id + " " + std::to_string(ahead) + " cases are before it, " +
                    std::to_string(others) + " other studies take turns or go first, and " +
                    std::to_string(running) + " cases run on " + std::to_string(places.slots) + " " +
                    places.slot_name);
}

ordered_json why_queued(Database& database, const std::string& case_id, const std::string& message,
                        std::int64_t not_before, const RunPlaces& places) {
  ordered_json reasons = ordered_json::array();
  if (!message.empty()) reasons.push_back(message);
  if (not_before > 0) reasons.push_back("not tried again before " + timestamp(not_before));
  Statement study = database.query(
      "SELECT s.id, s.cancelled_at IS NOT NULL, is_paused, s.number, min(position) FROM study_cases w"
      " JOIN studies s ON s.id = w.study_id JOIN schedule USING (number) WHERE w.case_id = ? GROUP BY s.id",
      case_id);
  while (study.step()) add_reason_of_study(database, study, places, reasons);
  if (!places.obstacle.empty()) reasons.push_back(places.obstacle);
  return reasons;
}

ordered_json why_running(Database& database, const std::string& case_id, const RunPlaces& places) {
  Statement row = database.query(
      "SELECT attempt, started_at, handle FROM attempts WHERE case_id = ? ORDER BY attempt DESC LIMIT 1",
      case_id);
  row.step();
  const RunPlace place = places.place_of(row.text(2));
  return {std::string(place.is_waiting ? "it was handed over at " : "it runs since ") +
          timestamp(row.integer(1)) + ", attempt " + std::to_string(row.integer(0)) + ", " + place.details};
}

/// Why the label of an answer is not confirmed; empty if it is.
/// \param row  confirmed, whether the companion's label agrees, error of Q and margin in the columns 5 to 8
std::string why_not_confirmed(const Statement& row) {
  if (row.is_null(5) || row.integer(5) != 0 || row.text(3) == "undecided") return "";
  if (row.is_null(7)) return "not confirmed: its error is unknown";
  if (row.integer(6) == 0) return "not confirmed: the run at the coarser resolution has another label";
  return "not confirmed: the estimated error of Q, " + row.text(7) +
         ", is not below the margin of the label, " + rounded(row.real(8)) +
         "; a finer fidelity may confirm it";
}

/// Of a case that has ended.
ordered_json why_ended(const Statement& row) {
  if (!row.text(1).empty()) return {row.text(1)};
  if (row.is_null(3)) return {"it has an answer"};
  ordered_json reasons = {row.text(3) + ": " + row.text(4)};
  if (const std::string reason = why_not_confirmed(row); !reason.empty()) reasons.push_back(reason);
  return reasons;
}

}  // namespace

void add_place(Database& database, const RunPlaces& places, ordered_json& shown) {
  if (shown["state"] != "running") return;
  Statement row = database.query("SELECT handle FROM attempts WHERE case_id = ? AND attempt = ?",
                                 shown["id"].get<std::string>(), shown["attempt"].get<std::int64_t>());
  if (row.step()) shown["where"] = places.place_of(row.text(0)).details;
}

void add_places(Database& database, const RunPlaces& places, ordered_json& cases) {
  for (ordered_json& shown : cases) add_place(database, places, shown);
}

std::optional<ordered_json> why(Database& database, const std::string& case_id, const RunPlaces& places) {
  Statement row = database.query(
      "SELECT state, message, not_before, r.motion, r.document ->> '$.explanation', r.document ->> "
      "'$.confirmed', r.document ->> '$.error.label_agrees', r.document ->> '$.error.Q', r.document ->> "
      "'$.evidence.margin' FROM cases c LEFT JOIN results r ON r.case_id = c.id WHERE c.id = ?",
      case_id);
  if (!row.step()) return std::nullopt;
  const std::string state = row.text(0);
  ordered_json answer = {{"id", case_id}, {"state", state}};
  if (state == "queued")
    answer["reasons"] = why_queued(database, case_id, row.text(1), row.integer(2), places);
  else if (state == "running")
    answer["reasons"] = why_running(database, case_id, places);
  else
    answer["reasons"] = why_ended(row);
  return answer;
}

}  // namespace capstan
