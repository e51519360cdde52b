#pragma once
// One time grid for the histories of a study, so that they are a table of points by times.
#include <optional>
#include <string>
#include <vector>

#include "runner/store/database.hpp"
#include "solver/case/output_times.hpp"
#include "solver/run_directory/history_line.hpp"

namespace capstan {

/// The times 0, `every`, 2 `every`, …
struct TimeGrid {
  double every = 0;
  std::size_t size = 0;

  double time(std::size_t index) const { return OutputTimes(every)[static_cast<long>(index)]; }
};

/// The grid up to the end of the study's longest run.
/// \param every  nothing: the shortest distance of records (outputs.history_every) in its cases
TimeGrid time_grid(Database& database, const std::string& study_id, std::optional<double> every);

/// The names of the observables that can be asked for on a grid: all that the database keeps but the time.
std::vector<std::string> columns_on_grid();

/// The history at the times of a grid. Between two records all observables are linear (angles are unwrapped);
/// before the first record and after the last they are NaN.
History on_grid(const History& records, const TimeGrid& grid);

}  // namespace capstan
