#include "runner/results/queries.hpp"
#include "runner/results/timestamp.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Number of the study's cases by state, all states listed.
ordered_json count_states(Database& database, const std::string& study_id) {
  ordered_json counts = {{"total", 0}};
  for (const char* state : {"queued", "running", "done", "failed", "diverged", "cancelled"})
    counts[state] = 0;
  Statement row = database.query(
      "SELECT state, count(*) FROM study_cases JOIN cases ON cases.id = case_id WHERE study_id = ? GROUP BY "
      "state",
      study_id);
  int total = 0;
  while (row.step()) {
    counts[row.text(0)] = row.integer(1);
    total += static_cast<int>(row.integer(1));
  }
  counts["total"] = total;
  return counts;
}

ordered_json count_motions(Database& database, const std::string& study_id) {
  ordered_json counts = {{"tumbling", 0}, {"tank_treading", 0}, {"transition", 0}, {"undecided", 0}};
  Statement row = database.query(
      "SELECT motion, count(*) FROM study_cases JOIN results USING (case_id)"
      " WHERE study_id = ? AND motion IS NOT NULL GROUP BY motion",
      study_id);
  while (row.step()) counts[row.text(0)] = row.integer(1);
  return counts;
}

/// The mean over the cases of the share of shear time that each has behind it.
double progress(Database& database, const std::string& study_id) {
  Statement row = database.query(
      "SELECT avg(CASE WHEN state IN ('queued', 'running')"
      " THEN min(1, kt / json_extract(document, '$.until.kt')) ELSE 1 END)"
      " FROM study_cases JOIN cases ON cases.id = case_id WHERE study_id = ?",
      study_id);
  row.step();
  return row.real(0);
}

ordered_json study_of(Database& database, const Statement& row) {
  const std::string id = row.text(0);
  ordered_json study = {{"id", id}, {"name", row.text(1)}, {"description", row.text(2)}};
  study["submitted_at"] = timestamp(row.integer(3));
  study["cancelled"] = !row.is_null(4);
  study["axes"] = ordered_json::parse(row.text(5));
  study["cases"] = count_states(database, id);
  study["motions"] = count_motions(database, id);
  study["progress"] = progress(database, id);
  return study;
}

constexpr const char* kColumns =
    "SELECT id, name, description, submitted_at, cancelled_at, axes FROM studies ";

}  // namespace

ordered_json list_studies(Database& database) {
  ordered_json studies = ordered_json::array();
  Statement row = database.query(std::string(kColumns) + "ORDER BY number DESC");
  while (row.step()) studies.push_back(study_of(database, row));
  return studies;
}

std::optional<ordered_json> find_study(Database& database, const std::string& study_id) {
  Statement row = database.query(std::string(kColumns) + "WHERE id = ?", study_id);
  if (!row.step()) return std::nullopt;
  return study_of(database, row);
}

}  // namespace capstan
