#include "runner/queries/queries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "runner/queries/boundary.hpp"
#include "runner/queue/case_state.hpp"
#include "runner/store/timestamp.hpp"
#include "solver/run_directory/result_words.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

constexpr const char* kColumns =
    "SELECT s.id, name, description, submitted_at, cancelled_at, axes, notes, priority, is_paused, s.number,"
    " document -> '$.boundary'"
    " FROM studies s JOIN schedule USING (number) ";
constexpr int kNumber = 9, kBoundary = 10;

/// One row of the table `tallies`: number and summed cost (estimated seconds of one core) of the cases in a
/// state, or the number of points.
struct Tally {
  std::int64_t count = 0;
  double cost = 0;
};

class Tallies {
 public:
  Tallies(Database& database, const std::string& study_id) {
    Statement row = database.query("SELECT word, count, cost FROM tallies WHERE study_id = ?", study_id);
    while (row.step()) tallies_[row.text(0)] = {row.integer(1), row.real(2)};
  }

  Tally of(std::string_view word) const {
    const auto found = tallies_.find(word);
    return found == tallies_.end() ? Tally{} : found->second;
  }

 private:
  std::map<std::string, Tally, std::less<>> tallies_;
};

/// Number of the study's distinct cases, in total and in each state.
ordered_json count_states(const Tallies& tallies) {
  ordered_json counts = {{"total", 0}};
  std::int64_t total = 0;
  for (const std::string_view state : words_of<CaseState>()) {
    const std::int64_t count = tallies.of(state).count;
    counts[std::string(state)] = count;
    total += count;
  }
  counts["total"] = total;
  return counts;
}

/// Number of the study's points of each motion.
ordered_json count_motions(const Tallies& tallies) {
  ordered_json counts;
  for (const std::string_view motion : words_of<Motion>())
    counts[std::string(motion)] = tallies.of(motion).count;
  return counts;
}

/// Cost of the computed parts of the cases that have begun and not ended.
double cost_begun(Database& database, const std::string& study_id) {
  Statement row = database.query(
      "SELECT total(cost * min(1, kt / json_extract(document, '$.until.kt'))"
      " * EXISTS (SELECT 1 FROM study_cases w WHERE w.case_id = c.id AND w.study_id = ?))"
      " FROM cases c INDEXED BY cases_begun WHERE kt > 0 AND state IN ('queued', 'running')",
      study_id);
  row.step();
  return row.real(0);
}

/// Computed share of the study's cost, from 0 to 1. Cancelled cases count as not computed, also after the end
/// of the study. Rounded, because the sums of costs are not exact.
/// \param expected  points that a search will probably still ask for; they cost as much as the others
double progress(Database& database, const std::string& study_id, const Tallies& tallies, int expected) {
  double total = 0, ended = 0;
  std::int64_t missing = 0, known = 0;
  for (const auto& [state, word] : kWords<CaseState>) {
    const Tally tally = tallies.of(word);
    total += tally.cost;
    known += tally.count;
    if (has_ended(state) && state != CaseState::cancelled)
      ended += tally.cost;
    else
      missing += tally.count;
  }
  if (missing == 0) return 1;
  total += total * expected / static_cast<double>(known);
  constexpr double kDigits = 1e6;
  const double share = (ended + cost_begun(database, study_id)) / total;
  return std::clamp(std::round(kDigits * share) / kDigits, 0.0, 1.0);
}

/// queued, running, paused, done or cancelled. A paused study whose last cases still run is paused; a study
/// that was cancelled after all its cases had ended is done.
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
  const Tallies tallies(database, id);
  ordered_json study = {{"id", id}, {"name", row.text(1)}, {"description", row.text(2)}};
  study["submitted_at"] = timestamp(row.integer(3));
  study["cancelled"] = !row.is_null(4);
  study["paused"] = row.integer(8) != 0;
  study["priority"] = row.integer(7);
  study["axes"] = ordered_json::parse(row.text(5));
  study["notes"] = ordered_json::parse(row.text(6));
  study["boundary"] = row.is_null(kBoundary) ? ordered_json() : ordered_json::parse(row.text(kBoundary));
  study["points"] = tallies.of("points").count;
  study["cases"] = count_states(tallies);
  study["state"] = state_of(study);
  const bool is_searching = !study["boundary"].is_null() && study["state"] != "done";
  study["expected_points"] = is_searching ? expected_points(database, id) : 0;
  study["motions"] = count_motions(tallies);
  study["progress"] = progress(database, id, tallies, study["expected_points"]);
  return study;
}

/// Cuts a long description; find_study gives all of it.
void shorten(ordered_json& description) {
  constexpr std::size_t kMax = 200;
  std::string& text = description.get_ref<std::string&>();
  if (text.size() <= kMax) return;
  std::size_t end = kMax;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // not within a UTF-8 sequence
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
