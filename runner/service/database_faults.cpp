#include "runner/service/database_faults.hpp"

namespace capstan {
namespace {

std::vector<std::string> first_column(Statement row) {
  std::vector<std::string> values;
  while (row.step()) values.push_back(row.text(0));
  return values;
}

}  // namespace

std::vector<std::string> damage_of(Database& database) {
  std::vector<std::string> faults = first_column(database.query("PRAGMA integrity_check(20)"));
  if (faults.size() == 1 && faults[0] == "ok") faults.clear();
  for (const std::string& table : first_column(database.query("PRAGMA foreign_key_check")))
    faults.push_back("a row of " + table + " refers to what is not there");
  return faults;
}

std::vector<std::string> miscounted_studies(Database& database) {
  return first_column(database.query(
      "SELECT study_id FROM schedule JOIN ("
      " SELECT study_id, sum(state = 'queued') queued, sum(state = 'running') running, sum(state = 'done') "
      "done,"
      " sum(state = 'failed') failed, sum(state = 'diverged') diverged, sum(state = 'cancelled') cancelled,"
      " sum(motion IS 'tumbling') tumbling, sum(motion IS 'tank_treading') tank_treading,"
      " sum(motion IS 'transition') transition, sum(motion IS 'undecided') undecided,"
      " sum(cost) cost_total, sum(cost * (state NOT IN ('queued', 'running'))) cost_ended"
      " FROM study_cases w JOIN cases ON id = w.case_id LEFT JOIN results r ON r.case_id = id GROUP BY "
      "study_id) c"
      " USING (study_id)"
      " WHERE (schedule.queued, schedule.running, schedule.done, schedule.failed, schedule.diverged,"
      " schedule.cancelled, schedule.tumbling, schedule.tank_treading, schedule.transition, "
      "schedule.undecided)"
      " IS NOT (c.queued, c.running, c.done, c.failed, c.diverged, c.cancelled, c.tumbling, c.tank_treading,"
      " c.transition, c.undecided)"
      // sums of costs are kept by adding and taking away, which is not exact
      " OR max(abs(schedule.cost_total - c.cost_total), abs(schedule.cost_ended - c.cost_ended))"
      "  > 1e-6 * c.cost_total"
      " UNION SELECT s.id FROM studies s WHERE cancelled_at IS NULL AND"
      " (SELECT count(*) FROM study_cases w JOIN cases c ON c.id = w.case_id"
      "  WHERE w.study_id = s.id AND c.state = 'queued') <>"
      " (SELECT count(*) FROM waiting WHERE study_number = s.number)"));
}

}  // namespace capstan
