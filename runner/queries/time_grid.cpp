#include "runner/queries/time_grid.hpp"

#include <algorithm>

#include "runner/store/history_columns.hpp"

namespace capstan {
namespace {

/// Relative. Times that differ by less are equal, because the times of records are rounded.
constexpr double kTimeTolerance = 1e-9;

bool is_before(double time, double other) { return time < other - kTimeTolerance * std::max(1.0, other); }

Record between(const Record& before, const Record& after, double kt) {
  const double share = (kt - before["kt"]) / (after["kt"] - before["kt"]);
  Record record;
  for (std::size_t i = 0; i < kObservableCount; ++i)
    record.values[i] = (1 - share) * before.values[i] + share * after.values[i];
  return record;
}

}  // namespace

TimeGrid time_grid(Database& database, const std::string& study_id, std::optional<double> every) {
  constexpr double kMaxSize = 1e9;  // a grid beyond all limits is still counted without an overflow
  Statement row = database.query(
      "SELECT ifnull(max(c.kt), 0), min(c.document ->> '$.outputs.history_every') FROM study_cases s"
      " JOIN cases c ON c.id = s.case_id WHERE s.study_id = ?",
      study_id);
  row.step();
  const double end = row.real(0), distance = every.value_or(row.real(1));
  return {distance, static_cast<std::size_t>(std::min(end / distance * (1 + kTimeTolerance), kMaxSize)) + 1};
}

std::vector<std::string> columns_on_grid() {
  std::vector<std::string> columns = history_columns();
  std::erase(columns, "kt");
  return columns;
}

History on_grid(const History& records, const TimeGrid& grid) {
  History history;
  auto next = records.begin();  // the first record that is not before the time
  for (std::size_t i = 0; i < grid.size; ++i) {
    const double kt = grid.time(i);
    while (next != records.end() && is_before((*next)["kt"], kt)) ++next;
    const bool has_ended = next == records.end();
    if (!has_ended && !is_before(kt, (*next)["kt"]))
      history.push_back(*next);
    else
      history.push_back(has_ended || next == records.begin() ? Record()
                                                             : between(*std::prev(next), *next, kt));
  }
  return history;
}

}  // namespace capstan
