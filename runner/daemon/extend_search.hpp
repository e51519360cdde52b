#pragma once
// Further points of studies that seek a boundary or refine their grid. All functions add those that the
// recorded results call for (next_points.hpp), and none that are there: they can be called at any time, any
// number of times.
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// Extends a study, unless it is cancelled.
void extend_search(Database& database, const std::string& study_id);

/// Extends all studies that contain a case: when it has ended.
void extend_searches_with(Database& database, const std::string& case_id);

/// Extends all studies: at the start of the daemon, in case an earlier program left something to do.
void extend_all_searches(Database& database);

}  // namespace capstan
