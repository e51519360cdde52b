#include "runner/queries/queries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runner/queue/case_state.hpp"
#include "runner/store/timestamp.hpp"
#include "solver/run_directory/motion.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// The study's columns; the counts begin at the ninth.
constexpr const char* kColumns =
    "SELECT s.id, name, description, submitted_at, cancelled_at, axes, priority, is_paused,"
    " queued, running, done, failed, diverged, cancelled, tumbling, tank_treading, transition, undecided,"
    " s.number, cost_total, cost_ended, points, notes FROM studies s JOIN schedule USING (number) ";
constexpr int kFirstCount = 8;
constexpr int kNumber = 18, kCostTotal = 19, kCostEnded = 20, kPoints = 21, kNotes = 22;

/// Number of the study's cases by state, all states listed.
ordered_json count_states(const Statement& row) {
  ordered_json counts = {{"total", 0}};
  std::int64_t total = 0;
  int column = kFirstCount;
  for (const CaseState state : kCaseStates) {
    counts[std::string(to_string(state))] = row.integer(column);
    total += row.integer(column++);
  }
  counts["total"] = total;
  return counts;
}

ordered_json count_motions(const Statement& row) {
  ordered_json counts;
  int column = kFirstCount + static_cast<int>(kCaseStates.size());
  for (const Motion motion : kMotions) counts[std::string(to_string(motion))] = row.integer(column++);
  return counts;
}

/// The cost behind the cases that have begun and not ended.
double cost_begun(Database& database, const std::string& study_id) {
  Statement row = database.query(
      "SELECT total(cost * min(1, kt / json_extract(document, '$.until.kt'))"
      " * EXISTS (SELECT 1 FROM study_cases w WHERE w.case_id = c.id AND w.study_id = ?))"
      " FROM cases c INDEXED BY cases_begun WHERE kt > 0 AND state IN ('queued', 'running')",
      study_id);
  row.step();
  return row.real(0);
}

/// The share of the study's cost that is behind it, rounded: sums of costs are not exact. What was cancelled
/// is missing, also when the study has ended.
double progress(Database& database, const std::string& study_id, const ordered_json& cases,
                const Statement& row) {
  if (cases["queued"] == 0 && cases["running"] == 0 && cases["cancelled"] == 0) return 1;
  constexpr double kDigits = 1e6;
  const double share = (row.real(kCostEnded) + cost_begun(database, study_id)) / row.real(kCostTotal);
  return std::clamp(std::round(kDigits * share) / kDigits, 0.0, 1.0);
}

/// queued, running, paused, done or cancelled. What a paused study still runs does not change that it is
/// paused; nor does a cancellation that came after all cases had ended change that they are done.
const char* state_of(const ordered_json& study) {
  const ordered_json& cases = study["cases"];
  const bool has_ended = cases["queued"] == 0 && cases["running"] == 0;
  if (study["cancelled"] && (!has_ended || cases["cancelled"] > 0)) return "cancelled";
  if (has_ended) return "done";
  if (study["paused"]) return "paused";
  return cases["running"] > 0 ? "running" : "queued";
}

ordered_json study_of(Database& database, const Statement& row) {
  const std::string id = row.text(0);
  ordered_json study = {{"id", id}, {"name", row.text(1)}, {"description", row.text(2)}};
  study["submitted_at"] = timestamp(row.integer(3));
  study["cancelled"] = !row.is_null(4);
  study["paused"] = row.integer(7) != 0;
  study["priority"] = row.integer(6);
  study["axes"] = ordered_json::parse(row.text(5));
  study["notes"] = ordered_json::parse(row.text(kNotes));
  study["points"] = row.integer(kPoints);
  study["cases"] = count_states(row);
  study["state"] = state_of(study);
  study["motions"] = count_motions(row);
  study["progress"] = progress(database, id, study["cases"], row);
  return study;
}

/// The beginning of a long description; the whole one is in the study itself.
void shorten(ordered_json& description) {
  constexpr std::size_t kMax = 200;
  std::string& text = description.get_ref<std::string&>();
  if (text.size() <= kMax) return;
  std::size_t end = kMax;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // not within a character
  text = text.substr(0, end) + "...";
}

}  // namespace

Page list_studies(Database& database, const PageRequest& wanted) {
  Page page{ordered_json::array(), std::nullopt};
  Statement row =
      database.query(std::string(kColumns) + "WHERE s.number < ? ORDER BY s.number DESC LIMIT ?",
                     wanted.after.value_or(std::numeric_limits<std::int64_t>::max()), wanted.limit + 1);
  std::size_t size = 0;
  for (std::int64_t last = 0; row.step(); last = row.integer(kNumber)) {
    if (std::ssize(page.items) == wanted.limit || size > kPageBytes) {
      page.next = last;
      break;
    }
    page.items.push_back(study_of(database, row));
    shorten(page.items.back()["description"]);
    size += page.items.back().dump().size();
  }
  return page;
}

std::optional<ordered_json> find_study(Database& database, const std::string& study_id) {
  Statement row = database.query(std::string(kColumns) + "WHERE s.id = ?", study_id);
  if (!row.step()) return std::nullopt;
  return study_of(database, row);
}

}  // namespace capstan
