#pragma once
// The observables of a run at one time.
#include "solver/observe/observables.hpp"
#include "solver/observe/snapshot.hpp"

namespace capstan {

/// All rows of kObservables, each in the unit of its row.
Record measure_all(const Snapshot& snapshot);

}  // namespace capstan
